#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"

namespace raceway::correction {

/// A share of the displacement that a lag of an input makes, or the input itself at once.
struct DrivenShare {
  Input input{};
  double gain = 0.0;             ///< [um] per unit of the input, as people read it
  double time_constant = unset;  ///< [s]; NaN: at once
};

/// A share of a motor that warms up with or against the spindle: a lag of exp(-n/n0) while it
/// turns.
struct MotorShare {
  double gain = 0.0;         ///< [um]
  double time_constant = 0;  ///< [s]
  double decay_speed = 0;    ///< n0 [rpm]
};

/// A share that settles once, from the start of the record: size (1 - exp(-t/τ)).
struct SettlingShare {
  double size = 0.0;         ///< [um]
  double time_constant = 0;  ///< [s]
};

/// Steps of a reading at given times.
struct JumpShare {
  struct Jump {
    double size = 0.0;  ///< [um]
    double time = 0.0;  ///< of the clock of the record [s]
  };
  std::vector<Jump> jumps{};
};

/// Contribution of an effect to the displacement. Simulation, step responses and exported programs
/// use it, so that they agree. Empty for an effect that changes the response of a channel.
using Share =
    std::variant<std::monostate, DrivenShare, MotorShare, SettlingShare, JumpShare, Kinematic>;

/// Takes weight [m] times values, one for each row. What a Series keeps is the same object whenever
/// it is made of the same numbers.
using Sink = std::function<void(double weight, const Series::Values& values)>;

/// Simulates a share on a record. `seen`: speeds [rpm] beyond which laws are continued().
void add_share(const Share& share, const Series& series, const Interval& seen, const Sink& sink);

}  // namespace raceway::correction
