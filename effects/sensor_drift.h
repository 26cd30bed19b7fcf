#pragma once

#include <array>
#include <span>

#include "effects/sensor_card.h"

namespace raceway::effects {

/// Temperature drift of a sensor, or thermal growth of its fixture [SI unit of its channel].
///
///   x_read = x + c (T - T0)/10 K
///
/// x is the true value, and c the drift per 10 K.
/// Source:   definition. T0 is the temperature at which the sensor was set to zero. T0 is rarely
///           recorded, so the fit finds T0 within the temperature range of the record.
/// Domain:   every reading. T is the temperature in the column temperature_C, not a ring
///           temperature.
template <const auto& card>
struct SensorTemperatureDrift : SensorFault<card> {
  static constexpr std::array parameters{card.size, Parameter{.name = "zero_at_C",
                                                              .unit = "C",
                                                              .initial = 40.0,
                                                              .lower = -100.0,
                                                              .upper = 300.0,
                                                              .plausible_lower = 15.0,
                                                              .plausible_upper = 50.0,
                                                              .neutral = unset,
                                                              .of_the_record = true}};
  static constexpr std::array needs{Need::viscosity_levels};

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return values[0] * card.channel.factor * (in.point.temperature - kelvin(values[1])) / 10.0;
  }
};

/// Time drift of a sensor [SI unit of its channel].
///
///   x_read = x + c t/1 h
///
/// x is the true value, t the time of the row, and c the drift per hour.
/// Source:   definition. If the points are measured in random order, the data can distinguish the
///           drift from the influence of speed and load.
/// Domain:   the record must contain the time of each row.
template <const auto& card>
struct SensorTimeDrift : SensorFault<card> {
  static constexpr std::array needs{Need::time};

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return values[0] * card.channel.factor * in.record.time / 3600.0;
  }
};

/// Data sheets of torque sensors give a drift of 0.05 to 0.5 % of full scale per 10 K. The full
/// scale is assumed proportional to the torque of the bearing, so the plausible drift grows with
/// the bearing size.
inline constexpr SensorCard<3> torque_temperature_drift{
    .channel = record::friction_torque,
    .id = "torque-temperature-drift",
    .title = "zero of the torque sensor drifts with temperature",
    .mechanism =
        "The zero of the sensor moves with temperature. This error does not depend on speed "
        "or load.",
    .formula =
        "M_read = M + c (T - T0)/10 K (M: true torque, c: drift per 10 K, T: temperature, T0: "
        "temperature at which the zero was set)",
    .confused_with = {"seal-friction", "churning", "cage-friction"},
    .size = {.name = "torque_per_10_K_Nmm",
             .unit = "N mm",
             .initial = 0.0,
             .lower = -1e5,
             .upper = 1e5,
             .plausible_lower = -20.0,
             .plausible_upper = 20.0},
    .size_power = 3.0,
    .settled_by = "the torque of the standing shaft, cold and warm"};

inline constexpr SensorCard<1> torque_time_drift{
    .channel = record::friction_torque,
    .id = "torque-time-drift",
    .title = "zero of the torque sensor drifts with time",
    .mechanism =
        "The zero of the sensor moves at a constant rate from the start to the end of the "
        "measurement.",
    .formula = "M_read = M + c t/1 h (M: true torque, c: drift per hour, t: time)",
    .confused_with = {"grease-churning"},
    .size = {.name = "torque_per_hour_Nmm",
             .unit = "N mm",
             .initial = 0.0,
             .lower = -1e5,
             .upper = 1e5,
             .plausible_lower = -20.0,
             .plausible_upper = 20.0},
    .size_power = 3.0,
    .settled_by = "a repetition of the first points at the end of the test"};

/// Data sheets of eddy-current transducers give a drift of 0.02 to 0.05 % of full scale per kelvin:
/// 2 to 5 um per 10 K for a range of 1 mm. This effect does not include the displacement caused by
/// ring temperatures, which is part of the equilibrium of the bearing sets.
inline constexpr SensorCard<3> displacement_temperature_drift{
    .channel = record::axial_displacement,
    .id = "displacement-temperature-drift",
    .title = "zero of the displacement transducer drifts with temperature",
    .mechanism =
        "Transducer and fixture move with temperature, at all speeds including standstill.",
    .formula =
        "u_read = u + c (T - T0)/10 K (u: true displacement, c: drift per 10 K, T: "
        "temperature, T0: temperature at which the zero was set)",
    .source = "definition; data sheets of eddy-current transducers",
    .confused_with = {"thermal-preload", "thermal-ring-growth", "displacement-offset"},
    .size = {.name = "displacement_per_10_K_um",
             .unit = "um",
             .initial = 0.0,
             .lower = -1e4,
             .upper = 1e4,
             .plausible_lower = -5.0,
             .plausible_upper = 5.0},
    .follows_heat = true};

}  // namespace raceway::effects
