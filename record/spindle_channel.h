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

/// The quantity of a column of a spindle's record or speed programme, null for a name that is none:
/// time_s, run_id, speed_rpm, axial_load_N, radial_load_N, coolant_on, motor_heat_W,
/// ambient_temperature_C, machine_temperature_C, coolant_inlet_temperature_C; measured are
/// axial_displacement_um (with std_um) and every other NAME_temperature_C, of a sensor. As
/// series_channel(), which knows temperatures as inputs.
[[nodiscard]] const Channel* spindle_channel(std::string_view name);

/// Temperature of the sensor of that name, measured.
[[nodiscard]] const Channel& sensor_channel(std::string_view sensor);

}  // namespace raceway::record
