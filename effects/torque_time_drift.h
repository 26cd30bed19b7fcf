#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Torque that the sensor adds as time goes by [N m].
///
///   M = c t/1 h
///
/// Source:   definition. Points measured in random order keep it apart from speed and load.
/// Domain:   a time of each row, by the clock of the file.
struct TorqueTimeDrift {
  static constexpr std::string_view id = "torque-time-drift";
  static constexpr std::string_view title = "zero of the torque sensor drifts with time";
  static constexpr std::string_view mechanism =
      "The zero of the sensor moves steadily from the start of the measurement to its end.";
  static constexpr std::string_view formula = "M_read = M + c t/1 h";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 1> confused_with{"grease-churning"};
  static constexpr std::array parameters{Parameter{.name = "torque_per_hour_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 0.0,
                                                   .lower = -1e5,
                                                   .upper = 1e5,
                                                   .plausible_lower = -20.0,
                                                   .plausible_upper = 20.0}};
  static constexpr std::array needs{Need::time};

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return values[0] * N_mm * in.record.time / 3600.0;
  }
};

}  // namespace raceway::effects
