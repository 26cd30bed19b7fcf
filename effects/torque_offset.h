#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Torque that the sensor shows at zero [N m].
///
///   M = c
///
/// Source:   definition. The same as seal-friction with slope zero; turning the other way round
///           separates them.
/// Domain:   every torque.
struct TorqueOffset {
  static constexpr std::string_view id = "torque-offset";
  static constexpr std::string_view title = "zero error of the torque sensor";
  static constexpr std::string_view mechanism =
      "The sensor shows a torque where there is none. Readings at standstill before and after, or "
      "turning the other way round, show it.";
  static constexpr std::string_view formula = "M_read = M + c";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 3> confused_with{"seal-friction", "load-offset",
                                                                 "mixed-lubrication"};
  static constexpr std::array parameters{Parameter{.name = "torque_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 0.0,
                                                   .lower = -1e5,
                                                   .upper = 1e5,
                                                   .plausible_lower = -100.0,
                                                   .plausible_upper = 100.0}};
  static constexpr std::array<Need, 0> needs{};

  static double reading(const ReadingInputs&, std::span<const double> values) {
    return values[0] * N_mm;
  }
};

}  // namespace raceway::effects
