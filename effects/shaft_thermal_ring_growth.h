#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Radial growth of the inner raceway against the outer one by ring temperatures, beyond the free
/// expansion of the rings, in the sets of a shaft [m].
///
///   g = c (T_i - T_o)
///
/// The free expansion of rings and balls at the temperatures of a row, or of the model, is in the
/// balance of the sets already (bearing::thermal_shift), so that c = 0 is rings that nothing holds.
/// c > 0: the housing keeps the outer ring from growing, or the sensors stand outside the rings and
/// see less than the raceways; c < 0: the shaft holds the inner ring. -λ d_m/2 (0.5 um/K at d_m
/// 90 mm, steel) takes the whole radial expansion away.
/// Source:   derived.
/// Domain:   both ring temperatures known.
struct ShaftThermalRingGrowth {
  static constexpr std::string_view id = "thermal-ring-growth";
  static constexpr Subject subject = Subject::shaft;
  static constexpr std::string_view title = "rings that do not grow freely with temperature";
  static constexpr std::string_view mechanism =
      "The free expansion of rings at their measured temperatures is part of every prediction. A "
      "stiff or cool housing, the shaft, or sensors away from the raceways make the real growth "
      "larger or smaller.";
  static constexpr std::string_view formula =
      "inner raceway grows by c (T_i - T_o) in radius beyond the free expansion";
  static constexpr std::string_view source = "free thermal expansion as reference, derived";
  static constexpr std::array<std::string_view, 3> confused_with{
      "thermal-preload", "centrifugal-ring-growth", "displacement-temperature-drift"};
  static constexpr std::array parameters{Parameter{.name = "growth_per_kelvin_um_K",
                                                   .unit = "um/K",
                                                   .initial = 0.1,
                                                   .lower = -3.0,
                                                   .upper = 3.0,
                                                   .plausible_lower = -0.5,
                                                   .plausible_upper = 0.5}};
  static constexpr bool follows_heat = true;
  static constexpr std::array needs{Need::ring_temperatures};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.radial_growth +=
        values[0] * um * (in.record.inner_ring_temperature - in.record.outer_ring_temperature);
  }
};

}  // namespace raceway::effects
