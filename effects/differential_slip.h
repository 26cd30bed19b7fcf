#pragma once

#include <array>
#include <string_view>

#include "effects/ball_sum.h"
#include "effects/effect.h"

namespace raceway::effects {

/// Friction moment of the differential slip in the contact ellipses (Heathcote slip) [N m].
///
///   M = μ Σ 0.0806 Q a²/R ω_roll/ω       over all contacts,  R = 2 f D/(2 f + 1)
///
/// μ is the friction coefficient, Q the contact load, a the semi-major axis of the contact ellipse,
/// f the conformity, and D the ball diameter. ω_roll/ω is the ratio of rolling speed to shaft
/// speed; see sum_over_contacts().
/// Source:   derived. The contact surface of ball and groove has the radius R across the rolling
///           direction. The slip speed at a distance y from the centre is therefore ω_roll (y² -
///           y0²)/(2 R), which is zero at y = y0. With the Hertz pressure integrated along the
///           rolling direction, the friction forces balance at y0 = 0.347 a. The friction power of
///           a contact is then 0.1611 μ Q ω_roll a²/(2 R). For comparison: the usual estimate of
///           the moment of a contact is about 0.1 μ Q a²/R.
/// Domain:   converged equilibrium of the balls; otherwise M is NaN.
/// Accuracy: the formula uses only slip along the rolling direction. If the ball also spins in the
///           contact, the true moment is smaller.
struct DifferentialSlip {
  static constexpr std::string_view id = "differential-slip";
  static constexpr std::string_view title = "slip across the curved contact (Heathcote slip)";
  static constexpr std::string_view mechanism =
      "The points of the curved contact ellipse have different radii, so only two lines of the "
      "ellipse roll without slip; the rest slides forward or backward.";
  static constexpr std::string_view formula =
      "M = sum of 0.0806 mu Q a^2/R w_roll/w over the contacts, R = 2 f D/(2 f + 1) (mu: "
      "friction coefficient, Q: contact load, a: half length of the contact ellipse, f: "
      "conformity, D: ball diameter, w_roll: rolling speed, w: shaft speed)";
  static constexpr std::string_view within_contacts =
      "mu_boundary under [friction], limiting_traction under [lubricant]";
  static constexpr std::string_view not_for_rollers =
      "a line contact has one rolling radius, without sliding zones";
  static constexpr std::string_view source = "derived from slip and Hertz pressure in the contact";
  static constexpr std::array<std::string_view, 3> confused_with{"z", "load-exponent",
                                                                 "elastic-hysteresis"};
  static constexpr std::array parameters{Parameter{.name = "friction_coefficient",
                                                   .unit = "1",
                                                   .initial = 0.06,
                                                   .lower = 0.0,
                                                   .upper = 2.0,
                                                   .plausible_lower = 0.02,
                                                   .plausible_upper = 0.15}};
  static constexpr std::array needs{Need::loads, Need::load_levels};
  static constexpr bool needs_equilibrium = true;

  static double unit_moment(const MomentInputs& in) {
    const double diameter = in.state.bearing->geometry().ball_diameter;
    return sum_over_contacts(in.state, [&](const RollingContact& c) {
      const double a = c.hertz.semi_major_axis(c.load);
      const double radius = 2.0 * c.conformity * diameter / (2.0 * c.conformity + 1.0);
      return 0.0806 * c.load * a * a / radius * c.rolling_ratio;
    });
  }
};

}  // namespace raceway::effects
