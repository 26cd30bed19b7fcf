#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Displacement that the transducer adds as it gets warm, or that its fixture grows by [m].
///
///   u_read = u + c (T - 40 °C)/10 K
///
/// Source:   definition; eddy-current transducers drift by 0.02 to 0.05 % of full scale per kelvin
///           [lit], 1 to 5 um per 10 K at 1 mm.
/// Domain:   every displacement; T is the temperature of the row (temperature_C), not that of a
/// ring:
///           ring temperatures act through the balance of the sets.
struct DisplacementTemperatureDrift {
  static constexpr std::string_view id = "displacement-temperature-drift";
  static constexpr std::string_view title =
      "zero of the displacement transducer drifts with warmth";
  static constexpr std::string_view mechanism =
      "Transducer and fixture move with temperature, whatever the speed is.";
  static constexpr std::string_view formula = "u_read = u + c (T - 40 C)/10 K";
  static constexpr std::string_view source = "definition; data sheets of eddy-current transducers";
  static constexpr std::array<std::string_view, 3> confused_with{
      "thermal-preload", "thermal-ring-growth", "displacement-offset"};
  static constexpr std::array parameters{Parameter{.name = "displacement_per_10_K_um",
                                                   .unit = "um",
                                                   .initial = 0.0,
                                                   .lower = -1e4,
                                                   .upper = 1e4,
                                                   .plausible_lower = -5.0,
                                                   .plausible_upper = 5.0}};
  static constexpr bool follows_heat = true;
  static constexpr std::array needs{Need::viscosity_levels};

  static double displacement(const DisplacementInputs& in, std::span<const double> values) {
    return values[0] * um * (in.point.temperature - kelvin(40.0)) / 10.0;
  }
};

}  // namespace raceway::effects
