#pragma once

#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Heat of a motor that a record brings [W].
inline constexpr Channel motor_heat{.name = "motor_heat_W",
                                    .variable = "motor_heat",
                                    .words = "motor heat",
                                    .unit = "W",
                                    .lower = 0,
                                    .upper = 1e7,
                                    .step = 5e-3,
                                    .ratio = true,
                                    .place = "W of the motor"};

/// Power that the motor takes, which a record brings [W].
inline constexpr Channel motor_power{.name = "motor_power_W",
                                     .variable = "motor_power",
                                     .words = "motor power",
                                     .unit = "W",
                                     .lower = 0,
                                     .upper = 1e7,
                                     .step = 5e-3,
                                     .ratio = true,
                                     .place = "W taken by the motor"};

/// Moment at the nose that a record brings, in the sense of a radial load further in front [N m].
inline constexpr Channel nose_moment{.name = "moment_Nm",
                                     .variable = "moment",
                                     .words = "moment at the nose",
                                     .unit = "N m",
                                     .lower = -1e5,
                                     .upper = 1e5,
                                     .step = 5e-3,
                                     .ratio = true,
                                     .place = "N m at the nose"};

/// Pull of a belt that a record brings [N].
inline constexpr Channel belt_force{.name = "belt_force_N",
                                    .variable = "belt_force",
                                    .words = "belt force",
                                    .unit = "N",
                                    .lower = 0,
                                    .upper = 1e8,
                                    .step = 5e-3,
                                    .ratio = true,
                                    .kind = "load",
                                    .place = "N of the belt"};

/// The quantity of a column of a spindle's record or speed programme, null for a name that is none:
/// time_s, run_id, speed_rpm, axial_load_N, radial_load_N, moment_Nm, belt_force_N, coolant_on,
/// motor_heat_W, motor_power_W,
/// ambient_temperature_C, machine_temperature_C, coolant_inlet_temperature_C; measured are
/// axial_displacement_um (with std_um) and every other NAME_temperature_C, of a sensor. As
/// series_channel(), which knows temperatures as inputs.
[[nodiscard]] const Channel* spindle_channel(std::string_view name);

/// Temperature of the sensor of that name, measured.
[[nodiscard]] const Channel& sensor_channel(std::string_view sensor);

}  // namespace raceway::record
