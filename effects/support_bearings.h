#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Friction of the support bearings of the rig, which the reading includes [N m].
///
///   M_read = M + c (s + (1 - s) (n/10 000 rpm)^(2/3))
///
/// M_read is the measured moment, M the moment of the tested bearing, and n the speed. c is the
/// moment of the support bearings at 10 000 rpm, and s is the share of c that does not depend on
/// the speed.
/// Source:   constant and viscous part of Palmgren's moment [Palmgren1959]. Load and temperature of
///           the support bearings are assumed constant.
/// Domain:   n >= 0, 0.1 <= s <= 0.7. With s = 1, the effect would be equal to the effect
///           torque-offset. With s = 0, the effect would be similar to rig-viscous-drag.
struct SupportBearings {
  static constexpr std::string_view id = "support-bearings";
  static constexpr std::string_view title = "the reading includes the support bearings of the rig";
  static constexpr std::string_view datum = "the tare torque of the support bearings";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the sensor also measures the support bearings of "
      "the shaft. Their torque has a constant part and a part that grows with speed, and "
      "does not depend on the load of the tested bearing.";
  static constexpr std::string_view formula =
      "M_read = M + c (s + (1 - s) (n/10000 rpm)^(2/3)) (M: torque of the tested bearing, "
      "c: moment of the support bearings at 10000 rpm, s: constant share of c, n: speed)";
  static constexpr std::string_view source =
      "derived from the constant and the viscous part of Palmgren's moment";
  static constexpr std::array<std::string_view, 4> confused_with{"torque-offset", "seal-friction",
                                                                 "rig-viscous-drag", "f0"};
  static constexpr std::string_view settled_by = "the torque of the rig without the bearing";
  static constexpr std::array parameters{Parameter{.name = "torque_at_10000_rpm_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 10.0,
                                                   .lower = 0.0,
                                                   .upper = 1e5,
                                                   .plausible_lower = 0.5,
                                                   .plausible_upper = 200.0},
                                         Parameter{.name = "constant_share",
                                                   .unit = "1",
                                                   .initial = 0.5,
                                                   .lower = 0.1,
                                                   .upper = 0.7,
                                                   .plausible_lower = 0.1,
                                                   .plausible_upper = 0.7,
                                                   .neutral = unset}};
  static constexpr double size_power = 3.0;
  static constexpr std::array needs{Need::speed_levels};
  static constexpr const record::Channel& channel = record::friction_torque;

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    const double speed = std::cbrt(in.point.speed / (10000.0 * rpm));
    return values[0] * N_mm * (values[1] + (1.0 - values[1]) * speed * speed);
  }

  static std::string correction(std::span<const double> values) {
    return fmt::format("{:.3g} N mm at 10 000 rpm, of which {:.3g} N mm does not depend on speed",
                       values[0], values[0] * values[1]);
  }
};

}  // namespace raceway::effects
