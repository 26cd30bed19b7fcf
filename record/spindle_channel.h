#pragma once

#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Recorded heat that the motor generates [W].
inline constexpr Channel motor_heat{.name = "motor_heat_W",
                                    .variable = "motor_heat",
                                    .words = "motor heat",
                                    .unit = "W",
                                    .lower = 0,
                                    .upper = 1e7,
                                    .step = 5e-3,
                                    .ratio = true,
                                    .place = "W motor heat"};

/// Recorded electrical power of the motor [W].
inline constexpr Channel motor_power{.name = "motor_power_W",
                                     .variable = "motor_power",
                                     .words = "motor power",
                                     .unit = "W",
                                     .lower = 0,
                                     .upper = 1e7,
                                     .step = 5e-3,
                                     .ratio = true,
                                     .place = "W motor power"};

/// Recorded moment at the spindle nose [N m]. A positive moment tilts the shaft in the same
/// direction as a positive radial load in front of the nose.
inline constexpr Channel nose_moment{.name = "moment_Nm",
                                     .variable = "moment",
                                     .words = "moment at the nose",
                                     .unit = "N m",
                                     .lower = -1e5,
                                     .upper = 1e5,
                                     .step = 5e-3,
                                     .ratio = true,
                                     .place = "N m moment at the nose"};

/// Recorded force of the belt on the shaft [N].
inline constexpr Channel belt_force{.name = "belt_force_N",
                                    .variable = "belt_force",
                                    .words = "belt force",
                                    .unit = "N",
                                    .lower = 0,
                                    .upper = 1e8,
                                    .step = 5e-3,
                                    .ratio = true,
                                    .kind = "load",
                                    .place = "N belt force"};

/// Returns the channel of a column of a spindle record or a speed programme; null for an unknown
/// name. Known names:
///   time_s, run_id
///   inputs: speed_rpm, axial_load_N, radial_load_N, moment_Nm, belt_force_N, coolant_on,
///     motor_heat_W, motor_power_W, ambient_temperature_C, machine_temperature_C,
///     coolant_inlet_temperature_C
///   readings: axial_displacement_um, its standard deviation std_um, and every other
///     NAME_temperature_C, which is the temperature of a sensor
///
/// In contrast, series_channel() treats all temperatures as inputs.
[[nodiscard]] const Channel* spindle_channel(std::string_view name);

/// Returns the channel for the measured temperature of the sensor with this name.
[[nodiscard]] const Channel& sensor_channel(std::string_view sensor);

}  // namespace raceway::record
