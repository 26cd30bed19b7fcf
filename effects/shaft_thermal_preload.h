#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Radial growth of the inner raceway against the outer one by the bearing's own heat, in the sets
/// of a shaft [m].
///
///   g = c P,   P = (M1 + M0) ω of the base law at the preload's share of the bearing
///
/// Source:   steady heat flow: the difference in temperature of the rings is in proportion to the
///           friction power (loop of Stein and Tu 1994, Bossmanns and Tu 1999); free expansion
///           λ d_m/2 of 0.5 um/K and 0.01 to 0.1 K/W between the rings give 0.005 to 0.05 um/W. P
///           at the load as mounted, so that the loop does not run away.
/// Domain:   speed >= 0. Beside measured ring temperatures, whose expansion is in the balance
///           already, c is what those temperatures do not show.
struct ShaftThermalPreload {
  static constexpr std::string_view id = "thermal-preload";
  static constexpr Subject subject = Subject::shaft;
  static constexpr std::string_view title = "preload that grows with the bearing's own heat";
  static constexpr std::string_view mechanism =
      "Friction warms the inner rings and the balls more than the outer rings. They have no room, "
      "and the sets press harder against each other as the friction power grows.";
  static constexpr std::string_view formula =
      "inner raceway grows by c P in radius, P = (M1 + M0) w at the preload";
  static constexpr std::string_view source =
      "steady heat flow, derived; loop of [SteinTu1994], [BossmannsTu1999]";
  static constexpr std::array<std::string_view, 4> confused_with{
      "centrifugal-ring-growth", "thermal-ring-growth", "shaft-contraction", "mounting"};
  static constexpr std::array parameters{Parameter{.name = "growth_per_power_um_W",
                                                   .unit = "um/W",
                                                   .initial = 0.01,
                                                   .lower = 0.0,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.001,
                                                   .plausible_upper = 0.1}};
  static constexpr bool follows_heat = true;
  static constexpr std::array needs{Need::speed_levels, Need::preload_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.radial_growth += values[0] * um * in.power;
  }
};

}  // namespace raceway::effects
