#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Axial load that grows with the bearing's own heat [N].
///
///   F_a -> F_a + c P,   P = (M1 + M0) ω at the entered load
///
/// Source:   steady heat flow: the difference in temperature of the rings, and with it the load of
/// a
///           rigid set, is in proportion to the friction power (Stein and Tu 1994; Bossmanns and Tu
///           1999 have the whole loop). P at the entered load, so that the loop does not run away.
/// Domain:   speed >= 0. c = 0 with springs.
struct ThermalPreload {
  static constexpr std::string_view id = "thermal-preload";
  static constexpr Subject subject = Subject::bearing;
  static constexpr std::string_view title = "preload that grows with the bearing's own heat";
  static constexpr std::string_view mechanism =
      "Friction warms the inner ring and the balls more than the outer ring. In a rigid set they "
      "have no room, and the load grows with the friction power.";
  static constexpr std::string_view formula =
      "F_a + c P in place of F_a, P = (M1 + M0) w at the entered load";
  static constexpr std::string_view source =
      "steady heat flow, derived; loop of [SteinTu1994], [BossmannsTu1999]";
  static constexpr std::array<std::string_view, 4> confused_with{
      "centrifugal-ring-growth", "spin-friction", "lubricant-drag", "windage"};
  static constexpr std::array parameters{Parameter{.name = "force_per_power_N_W",
                                                   .unit = "N/W",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 100.0,
                                                   .plausible_lower = 0.05,
                                                   .plausible_upper = 5.0}};
  static constexpr bool follows_heat = true;
  static constexpr std::array needs{Need::speed_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.extra_axial_load += values[0] * in.power;
  }
};

}  // namespace raceway::effects
