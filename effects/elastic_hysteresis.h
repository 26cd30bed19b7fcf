#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "effects/ball_sum.h"
#include "effects/effect.h"

namespace raceway::effects {

/// Friction moment of the steel that is deformed at each contact and does not give all back [N m].
///
///   M = c Σ M_h ω_roll/ω       over all contacts
///   M_h = 7.48e-7 (D/2)^0.33 Q^1.33 (1 - 3.52e-3 (κ - 1)^0.81)      [N m, m, N],  κ = a/b
///
/// Source:   M_h as quoted from Houpert (1997) in the literature; its print was not seen. The
///           exponents follow from a loss in proportion to the elastic work, M_h = (3/16) α Q b,
///           with b ~ (Q D)^(1/3), and the number then means a loss factor α of some per cent.
///           ω_roll/ω by power, derived.
/// Domain:   converged equilibrium, else NaN. Outer contacts carry the centrifugal force too: only
///           this makes the effect differ from the load moment of the base law.
struct ElasticHysteresis {
  static constexpr std::string_view id = "elastic-hysteresis";
  static constexpr std::string_view title = "hysteresis of the rolling contacts";
  static constexpr std::string_view mechanism =
      "Steel under a rolling ball does not give back all of the work that deformed it. The loss "
      "follows the ball loads, at the outer race with the centrifugal force.";
  static constexpr std::string_view formula =
      "M = c sum of 7.48e-7 (D/2)^0.33 Q^1.33 (1 - 3.52e-3 (a/b - 1)^0.81) w_roll/w, SI";
  static constexpr std::string_view source =
      "[Houpert] as quoted in the literature, print not seen; exponents derived";
  static constexpr std::array<std::string_view, 3> confused_with{"z", "load-exponent",
                                                                 "differential-slip"};
  static constexpr std::array parameters{Parameter{.name = "factor",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.0,
                                                   .upper = 30.0,
                                                   .plausible_lower = 0.3,
                                                   .plausible_upper = 3.0}};
  static constexpr std::array needs{Need::loads, Need::load_levels};
  static constexpr bool needs_equilibrium = true;

  static double unit_moment(const MomentInputs& in) {
    const double radius = 0.5 * in.state.bearing->geometry().ball_diameter;
    return sum_over_contacts(in.state, [&](const RollingContact& c) {
      const double shape = 1.0 - 3.52e-3 * std::pow(c.hertz.ellipse_ratio - 1.0, 0.81);
      return 7.48e-7 * std::pow(radius, 0.33) * std::pow(c.load, 1.33) * shape * c.rolling_ratio;
    });
  }
};

}  // namespace raceway::effects
