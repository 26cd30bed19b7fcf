#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Axial load that grows as the inner ring widens at speed [N].
///
///   F_a -> F_a + c (n/10 000 rpm)²
///
/// Source:   a ring that turns widens by about ρ ω² r³/E, derived for a thin ring; in a rigid set
///           the load follows the widening. The stiffness of the set is left to c.
/// Domain:   every speed; no lag, unlike thermal-preload.
struct CentrifugalRingGrowth {
  static constexpr std::string_view id = "centrifugal-ring-growth";
  static constexpr Subject subject = Subject::bearing;
  static constexpr std::string_view title = "inner ring that widens at speed";
  static constexpr std::string_view mechanism =
      "Centrifugal force widens the inner ring. In a rigid set the balls are pressed harder, at "
      "once and with the square of speed.";
  static constexpr std::string_view formula = "F_a + c (n/10000 rpm)^2 in place of F_a";
  static constexpr std::string_view source = "thin ring at speed, rho w^2 r^3/E, derived";
  static constexpr std::array<std::string_view, 4> confused_with{
      "thermal-preload", "lubricant-drag", "windage", "spin-friction"};
  static constexpr std::array parameters{Parameter{.name = "force_at_10000_rpm_N",
                                                   .unit = "N",
                                                   .initial = 50.0,
                                                   .lower = 0.0,
                                                   .upper = 20000.0,
                                                   .plausible_lower = 5.0,
                                                   .plausible_upper = 1000.0}};
  static constexpr std::array needs{Need::speed_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    const double ratio = in.point.speed / (10000.0 * rpm);
    c.extra_axial_load += values[0] * ratio * ratio;
  }
};

}  // namespace raceway::effects
