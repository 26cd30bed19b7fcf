#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Torque that the sensor adds in proportion [N m].
///
///   M = g M_rig
///
/// Source:   definition. Torque alone never shows it: it acts like a common factor on all moments.
/// Domain:   every torque.
struct TorqueGain {
  static constexpr std::string_view id = "torque-gain";
  static constexpr std::string_view title = "gain error of the torque sensor";
  static constexpr std::string_view mechanism =
      "The sensor reads all torques a fixed share too high or too low. Only a known torque shows "
      "it.";
  static constexpr std::string_view formula = "M_read = (1 + g) M";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 2> confused_with{"f0", "z"};
  static constexpr std::array parameters{Parameter{.name = "gain_error",
                                                   .unit = "1",
                                                   .initial = 0.0,
                                                   .lower = -0.5,
                                                   .upper = 0.5,
                                                   .plausible_lower = -0.01,
                                                   .plausible_upper = 0.01}};
  static constexpr std::array needs{Need::torque_standard};

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return values[0] * in.torque;
  }
};

}  // namespace raceway::effects
