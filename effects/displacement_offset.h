#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Displacement that the transducer shows at zero [m].
///
///   u_read = u + c
///
/// Source:   definition: a transducer that was zeroed on a warm or turning shaft, or before it had
///           settled in its seats.
/// Domain:   every displacement.
struct DisplacementOffset {
  static constexpr std::string_view id = "displacement-offset";
  static constexpr std::string_view title = "zero error of the displacement transducer";
  static constexpr std::string_view mechanism =
      "The transducer was zeroed somewhere else than on the cold shaft at standstill. Readings at "
      "standstill before and after show it.";
  static constexpr std::string_view formula = "u_read = u + c";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 3> confused_with{
      "displacement-temperature-drift", "preload_N", "thermal-ring-growth"};
  static constexpr std::array parameters{Parameter{.name = "displacement_um",
                                                   .unit = "um",
                                                   .initial = 0.0,
                                                   .lower = -1e4,
                                                   .upper = 1e4,
                                                   .plausible_lower = -5.0,
                                                   .plausible_upper = 5.0}};
  static constexpr std::array<Need, 0> needs{};

  static double displacement(const DisplacementInputs&, std::span<const double> values) {
    return values[0] * um;
  }
};

}  // namespace raceway::effects
