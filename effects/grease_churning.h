#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Additional friction moment of grease during the churning phase [N m]:
///
///   M = A M0 exp(-t/τ)
///
/// M0 is the viscous moment of the friction law without effects, t the time, A the relative
/// increase of M0 at t = 0, and τ the time constant of the decay.
/// Source:   churning phase after Lugt (2009): M(t) = M_end (1 + A exp(-t/τ)), with A of 0.5 to 4
///           and τ of 1 to 20 h. The program applies this formula to the viscous moment, because
///           churning does not depend on load.
/// Domain:   grease lubrication. The record must contain the time of each row, and churning begins
///           at t = 0.
struct GreaseChurning {
  static constexpr std::string_view id = "grease-churning";
  static constexpr std::string_view title = "running-in of fresh grease";
  static constexpr std::string_view mechanism =
      "The balls churn fresh grease until it is distributed. During this running-in, the "
      "viscous moment is higher, and it falls over hours.";
  static constexpr std::string_view formula =
      "M = A M0 exp(-t/tau) (A: factor, M0: viscous moment, t: time, tau: decay time)";
  static constexpr std::string_view source = "[Lugt2009]; the original was not available";
  static constexpr std::array<std::string_view, 2> confused_with{"torque-time-drift", "f0"};
  static constexpr std::string_view settled_by =
      "a repetition of the first points at the end of the test";
  static constexpr std::array parameters{Parameter{.name = "factor",
                                                   .unit = "1",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 20.0,
                                                   .plausible_lower = 0.1,
                                                   .plausible_upper = 4.0},
                                         Parameter{.name = "decay_time_h",
                                                   .unit = "h",
                                                   .initial = 5.0,
                                                   .lower = 0.1,
                                                   .upper = 100.0,
                                                   .plausible_lower = 1.0,
                                                   .plausible_upper = 20.0,
                                                   .neutral = unset}};
  static constexpr std::array needs{Need::time};
  static constexpr bool of_viscous_moment = true;
  static constexpr std::array supplies{friction::Supply::grease};

  static double moment(const MomentInputs& in, std::span<const double> values) {
    return values[0] * in.base.viscous * std::exp(-in.record.time / (values[1] * 3600.0));
  }
};

}  // namespace raceway::effects
