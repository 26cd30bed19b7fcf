#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Friction moment of rubbing seals [N m].
///
///   M = K (1 - s (T - 45 °C)),  not below zero
///
/// K is the moment at 45 °C, s its relative decrease per kelvin, and T the lubricant temperature.
/// Source:   the moment is independent of speed and load, like the seal moment of [SKFGeneral, p.
///           91-101]. The linear decrease with temperature is an assumption: warm rubber is softer,
///           and warm grease is thinner.
/// Domain:   every speed. If s = 0, the effect cannot be distinguished from a zero error of the
///           torque sensor (torque-offset).
struct SealFriction {
  static constexpr std::string_view id = "seal-friction";
  static constexpr std::string_view title = "rubbing seals";
  static constexpr std::string_view mechanism =
      "The friction of the seal lips does not depend on speed or load; warm lips are softer and "
      "have less friction.";
  static constexpr std::string_view formula =
      "M = K (1 - s (T - 45 C)), not below zero (K: moment at 45 C, s: slope, T: "
      "temperature)";
  static constexpr std::string_view source =
      "seal moment of the SKF general catalogue (2006); its decrease with temperature is assumed";
  static constexpr std::array<std::string_view, 4> confused_with{
      "torque-offset", "load-offset", "torque-temperature-drift", "mixed-lubrication"};
  static constexpr std::string_view settled_by = "the torque without the seals";
  static constexpr std::array parameters{Parameter{.name = "torque_at_45_C_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 10.0,
                                                   .lower = 0.0,
                                                   .upper = 2000.0,
                                                   .plausible_lower = 1.0,
                                                   .plausible_upper = 100.0},
                                         Parameter{.name = "slope_1_K",
                                                   .unit = "1/K",
                                                   .initial = 0.0075,
                                                   .lower = 0.0,
                                                   .upper = 0.015,
                                                   .plausible_lower = 0.0,
                                                   .plausible_upper = 0.015,
                                                   .neutral = unset}};
  static constexpr double size_power = 2.0;
  static constexpr std::array<Need, 0> needs{};

  static double moment(const MomentInputs& in, std::span<const double> values) {
    const double share = 1.0 - values[1] * (in.state.temperature - kelvin(45.0));
    return values[0] * N_mm * std::max(share, 0.0);
  }
};

}  // namespace raceway::effects
