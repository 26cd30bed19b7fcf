#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"

namespace raceway::correction {

/// Contribution to the displacement that is proportional to an input, with a first-order lag or
/// without one.
struct DrivenShare {
  Input input{};
  double gain = 0.0;             ///< gain [um] per unit of the input, see Input::unit()
  double time_constant = unset;  ///< time constant of the lag [s]; NaN: no lag
};

/// Contribution of a motor that heats up or cools down with the spindle: a first-order lag whose
/// input is exp(-n/n0) while the spindle turns at the speed n, and 0 at standstill.
struct MotorShare {
  double gain = 0.0;         ///< [um]
  double time_constant = 0;  ///< [s]
  double decay_speed = 0;    ///< speed n0 [rpm]
};

/// Contribution that approaches a final value: size (1 - exp(-t/τ)), with the time constant τ and
/// the time t since the start of the record.
struct SettlingShare {
  double size = 0.0;         ///< [um]
  double time_constant = 0;  ///< [s]
};

/// Contribution that is a sum of steps. Each step begins at a given time.
struct JumpShare {
  struct Jump {
    double size = 0.0;  ///< [um]
    double time = 0.0;  ///< value of time_s from which the step is added [s]
  };
  std::vector<Jump> jumps{};
};

/// Contribution of an effect to the displacement. Simulation, step responses and exported programs
/// use the same contribution, so their results agree. An effect that only changes the response of a
/// channel has no contribution (std::monostate).
using Share =
    std::variant<std::monostate, DrivenShare, MotorShare, SettlingShare, JumpShare, Kinematic>;

/// Function that receives one term of the displacement. The term at each row is `weight` times the
/// element of `values` for this row [m].
using Sink = std::function<void(double weight, const Series::Values& values)>;

/// Simulates a contribution on a record and passes its terms to `sink`. `seen` is the speed range
/// of the fit [rpm]. Outside this range, continued() extrapolates the contributions that depend on
/// the speed.
void add_share(const Share& share, const Series& series, const Interval& seen, const Sink& sink);

}  // namespace raceway::correction
