#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Texts of a sensor fault on one channel, and the parameter that gives the size of the fault. The
/// formulas of the faults are in sensor_offset.h, sensor_gain.h and sensor_drift.h.
template <std::size_t confused>
struct SensorCard {
  const record::Channel& channel;  ///< channel that the sensor measures
  std::string_view id, title, mechanism, formula;
  std::string_view source = "definition";
  std::array<std::string_view, confused> confused_with;
  Parameter size;
  bool follows_heat = false;
  double size_power = 0.0;  ///< exponent p of the bearing size, see Nature::size_power
  std::string_view settled_by = {};
};

/// Members of an effect that are copied from its sensor card.
template <const auto& card>
struct SensorFault {
  static constexpr const record::Channel& channel = card.channel;
  static constexpr std::string_view id = card.id;
  static constexpr std::string_view title = card.title;
  static constexpr std::string_view mechanism = card.mechanism;
  static constexpr std::string_view formula = card.formula;
  static constexpr std::string_view source = card.source;
  static constexpr auto confused_with = card.confused_with;
  static constexpr std::array parameters{card.size};
  static constexpr bool follows_heat = card.follows_heat;
  static constexpr double size_power = card.size_power;
  static constexpr std::string_view settled_by = card.settled_by;
};

}  // namespace raceway::effects
