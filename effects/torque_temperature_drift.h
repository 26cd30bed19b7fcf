#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Torque that the sensor adds as it gets warm [N m].
///
///   M = c (T - 40 °C)/10 K
///
/// Source:   definition; data sheets give 0.05 to 0.5 % of full scale per 10 K.
/// Domain:   every torque; T is the temperature of the row.
struct TorqueTemperatureDrift {
  static constexpr std::string_view id = "torque-temperature-drift";
  static constexpr std::string_view title = "zero of the torque sensor drifts with temperature";
  static constexpr std::string_view mechanism =
      "The zero of the sensor moves with temperature, whatever speed and load are.";
  static constexpr std::string_view formula = "M_read = M + c (T - 40 C)/10 K";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 3> confused_with{"seal-friction", "churning",
                                                                 "cage-friction"};
  static constexpr std::array parameters{Parameter{.name = "torque_per_10_K_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 0.0,
                                                   .lower = -1e5,
                                                   .upper = 1e5,
                                                   .plausible_lower = -20.0,
                                                   .plausible_upper = 20.0}};
  static constexpr std::array needs{Need::viscosity_levels};

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return values[0] * N_mm * (in.point.temperature - kelvin(40.0)) / 10.0;
  }
};

}  // namespace raceway::effects
