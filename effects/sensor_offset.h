#pragma once

#include <array>
#include <span>

#include "effects/sensor_card.h"

namespace raceway::effects {

/// Zero error of a sensor [SI unit of its channel].
///
///   x_read = x + c
///
/// x is the true value, and c the zero error.
/// Source:   definition.
/// Domain:   every reading.
template <const auto& card>
struct SensorOffset : SensorFault<card> {
  static constexpr std::array<Need, 0> needs{};

  static double reading(const ReadingInputs&, std::span<const double> values) {
    return values[0] * card.channel.factor;
  }
};

/// If all readings are for one direction of rotation, this offset cannot be distinguished from
/// constant seal friction. In the other direction, the friction torque of the seals changes its
/// sign, but the offset does not.
inline constexpr SensorCard<3> torque_offset{
    .channel = record::friction_torque,
    .id = "torque-offset",
    .title = "zero error of the torque sensor",
    .mechanism =
        "The sensor shows a torque when there is none. Readings at standstill before and after the "
        "test, or in the other direction of rotation, show this error.",
    .formula = "M_read = M + c (M: true torque, c: zero error)",
    .confused_with = {"seal-friction", "load-offset", "mixed-lubrication"},
    .size = {.name = "torque_Nmm",
             .unit = "N mm",
             .initial = 0.0,
             .lower = -1e5,
             .upper = 1e5,
             .plausible_lower = -100.0,
             .plausible_upper = 100.0},
    .size_power = 3.0,
    .settled_by = "the torque of the standing shaft, or in both directions of rotation"};

/// Zero error of a transducer that was zeroed on a warm or turning shaft, or before the readings
/// had settled.
inline constexpr SensorCard<3> displacement_offset{
    .channel = record::axial_displacement,
    .id = "displacement-offset",
    .title = "zero error of the displacement transducer",
    .mechanism =
        "The transducer was not zeroed on the cold shaft at standstill. Readings at standstill "
        "before and after the test show this error.",
    .formula = "u_read = u + c (u: true displacement, c: zero error)",
    .confused_with = {"displacement-temperature-drift", "preload_N", "thermal-ring-growth"},
    .size = {.name = "displacement_um",
             .unit = "um",
             .initial = 0.0,
             .lower = -1e4,
             .upper = 1e4,
             .plausible_lower = -5.0,
             .plausible_upper = 5.0}};

}  // namespace raceway::effects
