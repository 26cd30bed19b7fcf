#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Radial growth of the inner raceway against the outer one by measured ring temperatures [m].
///
///   u = c λ (T_i - T_o) d_m/2        λ thermal expansion of the rings
///
/// changes the contact angle, at an entered axial load, by cos α0 -> cos α0 + u/(B D).
/// Source:   free thermal expansion, derived; c = 1 is rings that nothing holds.
/// Domain:   both ring temperatures measured. Balls at the temperature of the outer ring.
struct ThermalRingGrowth {
  static constexpr std::string_view id = "thermal-ring-growth";
  static constexpr Subject subject = Subject::bearing;
  static constexpr std::string_view title = "rings of different temperature";
  static constexpr std::string_view mechanism =
      "An inner ring that is warmer than the outer one grows into the clearance, and the balls run "
      "at a smaller contact angle and carry more for the same axial load.";
  static constexpr std::string_view formula = "u = c lambda (T_i - T_o) d_m/2";
  static constexpr std::string_view source = "free thermal expansion, derived";
  static constexpr std::array<std::string_view, 3> confused_with{
      "thermal-preload", "centrifugal-ring-growth", "interference-fit"};
  static constexpr std::array parameters{Parameter{.name = "share",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.0,
                                                   .upper = 2.0,
                                                   .plausible_lower = 0.3,
                                                   .plausible_upper = 1.5}};
  static constexpr bool follows_heat = true;
  static constexpr std::array needs{Need::ring_temperatures, Need::loads, Need::ball_load_law};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    const double difference = in.record.inner_ring_temperature - in.record.outer_ring_temperature;
    c.radial_growth += values[0] * in.bearing.rings().thermal_expansion * difference * 0.5 *
                       in.bearing.geometry().pitch_diameter;
  }
};

}  // namespace raceway::effects
