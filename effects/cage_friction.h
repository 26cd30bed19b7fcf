#pragma once

#include <array>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Friction moment of a land-guided cage [N m].
///
///   M = c (n/10 000 rpm) (ν/20 mm²/s)
///
/// c is the moment at 10 000 rpm and a viscosity ν of 20 mm²/s.
/// Source:   Petroff's law for a lightly loaded plain bearing [Harris2006, vol. 2, ch. 5]: the
///           moment is proportional to speed and viscosity. c is fitted.
/// Domain:   every speed.
struct CageFriction {
  static constexpr std::string_view id = "cage-friction";
  static constexpr std::string_view title = "friction of the cage on its guiding land";
  static constexpr std::string_view mechanism =
      "The cage runs on the land of a ring like a lightly loaded plain bearing. The drag of the "
      "cage is proportional to speed and viscosity.";
  static constexpr std::string_view formula =
      "M = c (n/10000 rpm) (nu/20 mm2/s) (n: speed, nu: viscosity, c: moment at 10000 rpm "
      "and 20 mm2/s)";
  static constexpr std::string_view source =
      "Petroff's law; Harris and Kotzalas, Rolling Bearing Analysis, vol. 2, ch. 5";
  static constexpr std::array<std::string_view, 4> confused_with{"f0", "viscous-exponent",
                                                                 "rig-viscous-drag", "churning"};
  static constexpr std::string_view settled_by =
      "the same points with a cage of different clearance";
  static constexpr std::array parameters{Parameter{.name = "torque_at_10000_rpm_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 10.0,
                                                   .lower = 0.0,
                                                   .upper = 1e5,
                                                   .plausible_lower = 0.5,
                                                   .plausible_upper = 200.0}};
  static constexpr double size_power = 3.0;
  static constexpr std::array needs{Need::speed_levels};

  static double unit_moment(const MomentInputs& in) {
    return (in.state.speed / (10000.0 * rpm)) *
           (in.state.kinematic_viscosity / (20.0 * mm2_per_s)) * N_mm;
  }
};

}  // namespace raceway::effects
