#pragma once

#include <array>
#include <span>

#include "effects/sensor_card.h"

namespace raceway::effects {

/// Gain error of a sensor [SI unit of its channel].
///
///   x_read = (1 + g) x        x in the unit of the channel, for example in N mm or °C
///
/// x is the true value, and g the relative error.
/// Source:   definition. The template parameter `standard` is the condition for a fit of g, such as
///           a known torque that fixes the scale of the sensor.
/// Domain:   every reading.
template <const auto& card, Need standard>
struct SensorGain : SensorFault<card> {
  static constexpr std::array needs{standard};

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return values[0] * (in.value - card.channel.offset);
  }
};

/// Torque readings alone cannot show a gain error of the torque sensor, because the error
/// multiplies all moments by the same factor.
inline constexpr SensorCard<2> torque_gain{
    .channel = record::friction_torque,
    .id = "torque-gain",
    .title = "gain error of the torque sensor",
    .mechanism =
        "The sensor reads all torques too high or too low by the same factor. Only a known torque "
        "shows this error.",
    .formula = "M_read = (1 + g) M (M: true torque, g: relative error)",
    .confused_with = {"f0", "z"},
    .size = {.name = "gain_error",
             .unit = "1",
             .initial = 0.0,
             .lower = -0.5,
             .upper = 0.5,
             .plausible_lower = -0.01,
             .plausible_upper = 0.01}};

}  // namespace raceway::effects
