#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"

namespace raceway::correction {

/// Contribution to the displacement that follows an input, with a first-order lag or instantly.
struct DrivenShare {
  Input input{};
  double gain = 0.0;             ///< [um] per unit of the input in text (Input::unit())
  double time_constant = unset;  ///< [s]; NaN: instant
};

/// Contribution of a motor that heats up or cools down with the spindle. The contribution follows
/// exp(-n/n0) with a first-order lag while the spindle turns. At standstill, the input of the lag
/// is 0.
struct MotorShare {
  double gain = 0.0;         ///< [um]
  double time_constant = 0;  ///< [s]
  double decay_speed = 0;    ///< n0 [rpm]
};

/// Contribution that settles from the start of the record: size (1 - exp(-t/τ)).
struct SettlingShare {
  double size = 0.0;         ///< [um]
  double time_constant = 0;  ///< [s]
};

/// Contribution with steps at given times.
struct JumpShare {
  struct Jump {
    double size = 0.0;  ///< [um]
    double time = 0.0;  ///< time on the clock of the record [s]
  };
  std::vector<Jump> jumps{};
};

/// Contribution of an effect to the displacement. Simulation, step responses and exported programs
/// all use this contribution, so their results agree. An effect that changes the response of a
/// channel has no contribution (std::monostate).
using Share =
    std::variant<std::monostate, DrivenShare, MotorShare, SettlingShare, JumpShare, Kinematic>;

/// Receives one term of the displacement: a weight, times a value for each row. A Series stores the
/// values, so calls with equal parameters receive the same object.
using Sink = std::function<void(double weight, const Series::Values& values)>;

/// Simulates a contribution on a record and passes its terms to `sink`. `seen` is the speed range
/// of the fit [rpm]. Beyond this range, continued() extrapolates laws of the speed.
void add_share(const Share& share, const Series& series, const Interval& seen, const Sink& sink);

}  // namespace raceway::correction
