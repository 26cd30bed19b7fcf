#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Drag of the hydrostatic or aerostatic support of the rig [N m].
///
///   M = c (n/10 000 rpm)
///
/// n is the speed, and c the moment at 10 000 rpm.
/// Source:   moment of a sheared film of constant height h: η ω A r²/h, derived (η: viscosity, ω:
///           angular speed, A: area of the film, r: its radius). η is assumed constant, because the
///           support does not have the temperature of the bearing.
/// Domain:   every speed. To distinguish this drag from the bearing friction, measure the torque
///           without the bearing.
struct RigViscousDrag {
  static constexpr std::string_view id = "rig-viscous-drag";
  static constexpr std::string_view title = "viscous drag of the support of the rig";
  static constexpr std::string_view mechanism =
      "The oil film that carries the housing or the shaft of the rig adds a torque proportional to "
      "speed, which does not depend on the bearing.";
  static constexpr std::string_view formula =
      "M_read = M + c (n/10000 rpm) (M: bearing torque, n: speed, c: moment of the support "
      "at 10000 rpm)";
  static constexpr std::string_view source = "shear of a film of constant height, derived";
  static constexpr std::array<std::string_view, 3> confused_with{"cage-friction", "lubricant-drag",
                                                                 "windage"};
  static constexpr std::string_view settled_by = "the torque of the rig without the bearing";
  static constexpr std::array parameters{Parameter{.name = "torque_at_10000_rpm_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 10.0,
                                                   .lower = 0.0,
                                                   .upper = 1e5,
                                                   .plausible_lower = 0.5,
                                                   .plausible_upper = 200.0}};
  static constexpr std::array needs{Need::speed_levels};
  static constexpr const record::Channel& channel = record::friction_torque;

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return values[0] * N_mm * in.point.speed / (10000.0 * rpm);
  }
};

}  // namespace raceway::effects
