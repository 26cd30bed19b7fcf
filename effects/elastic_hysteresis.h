#pragma once

#include <array>
#include <string_view>

#include "effects/ball_sum.h"
#include "effects/effect.h"
#include "friction/contact/hysteresis.h"

namespace raceway::effects {

using friction::contact::hysteresis_moment;

/// Friction moment of the elastic hysteresis in the rolling contacts [N m].
///
///   M = c Σ M_h ω_roll/ω       over all contacts, M_h by hysteresis_moment()
///
/// c is a factor that multiplies the published formula of M_h. ω_roll/ω is the ratio of rolling
/// speed to shaft speed; see sum_over_contacts().
/// Source:   for M_h see hysteresis_moment(). ω_roll/ω is derived from a power balance.
/// Domain:   converged equilibrium of the balls; otherwise M is NaN. The loads of the outer
///           contacts include the centrifugal force. Only this force distinguishes the effect from
///           the load moment of the friction law.
struct ElasticHysteresis {
  static constexpr std::string_view id = "elastic-hysteresis";
  static constexpr std::string_view title = "hysteresis of the rolling contacts";
  static constexpr std::string_view mechanism =
      "Steel under a rolling ball does not return all of the work of deformation. The loss grows "
      "with the ball loads, which at the outer race include the centrifugal force.";
  static constexpr std::string_view formula =
      "M = c sum of 7.48e-7 (D/2)^0.33 Q^1.33 (1 - 3.519e-3 (R_z/R_x - 1)^0.8063) "
      "(E'_steel/E')^(1/3) w_roll/w over the contacts, in SI units (c: factor, D: ball "
      "diameter, Q: contact load, R_x and R_z: equivalent radii along and across rolling, "
      "E': modulus of the contact, w_roll: rolling speed, w: shaft speed)";
  static constexpr std::string_view within_contacts = "hysteresis_factor under [friction]";
  static constexpr std::string_view not_for_rollers =
      "the formula of the effect is for point contacts";
  static constexpr std::string_view source =
      "[Houpert2002] as quoted by [Balan2015, eq. 9]; the originals were not available. The "
      "factor (E'_steel/E')^(1/3) is derived";
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
    const double diameter = in.state.bearing->geometry().ball_diameter;
    return sum_over_contacts(in.state, [&](const RollingContact& c) {
      return hysteresis_moment(diameter, c.load, c.radius_ratio, c.hertz.contact_modulus) *
             c.rolling_ratio;
    });
  }
};

}  // namespace raceway::effects
