#pragma once

#include <array>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Drag moment of balls and cage in the lubricant [N m].
///
///   M = c (n/10 000 rpm)²
///
/// c is the moment at 10 000 rpm.
/// Source:   inertia of a fluid that moving bodies push aside. The first term of the drag moment in
///           the SKF catalogues, 0.4 V_M K_ball d_m^5 n², has this form. V_M is the drag loss
///           factor, K_ball a constant of the bearing, and d_m the pitch diameter. A fit finds c
///           instead, because V_M depends on the oil level.
/// Domain:   every speed. The formula is for an oil bath and for an oil jet. According to SKF, an
///           oil jet causes twice the drag of an oil bath. The formula is not for oil-air
///           lubrication or worked-in grease, because the balls then push no lubricant aside.
struct LubricantDrag {
  static constexpr std::string_view id = "lubricant-drag";
  static constexpr std::string_view title = "drag of balls and cage in the lubricant";
  static constexpr std::string_view mechanism =
      "Balls and cage push lubricant aside outside the contacts. The inertia of the lubricant "
      "causes a drag that grows with the square of speed and does not depend on load or viscosity.";
  static constexpr std::string_view formula =
      "M = c (n/10000 rpm)^2 (n: speed, c: moment at 10000 rpm)";
  static constexpr std::string_view source = "form of the first term of the SKF drag moment";
  static constexpr std::array<std::string_view, 4> confused_with{
      "windage", "centrifugal-ring-growth", "gyroscopic-slip", "cage-friction"};
  static constexpr std::string_view settled_by =
      "the torque while the oil supply is shut off for a minute";
  static constexpr std::array parameters{Parameter{.name = "torque_at_10000_rpm_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 20.0,
                                                   .lower = 0.0,
                                                   .upper = 1e5,
                                                   .plausible_lower = 1.0,
                                                   .plausible_upper = 300.0}};
  static constexpr double size_power = 5.0;
  static constexpr std::array needs{Need::speed_levels};
  static constexpr bool within_oil_fraction = true;  // the same mechanism: pushed oil
  static constexpr std::array supplies{friction::Supply::jet, friction::Supply::bath};

  static double unit_moment(const MomentInputs& in) {
    const double ratio = in.state.speed / (10000.0 * rpm);
    return ratio * ratio * N_mm;
  }
};

}  // namespace raceway::effects
