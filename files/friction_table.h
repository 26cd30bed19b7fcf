#pragma once

#include <string>

#include "correction/characteristic.h"
#include "correction/friction_table.h"
#include "record/units.h"

namespace raceway::files {

/// Reads a friction table of a spindle: columns speed_rpm, axial_load_N, temperature_C and
/// friction_torque_Nmm, as `raceway table` writes them or as a rig gives them; further axes and
/// columns are welcome, as long as each point of the three stands once. A load or a temperature
/// that has no column is one for all. Of several radial loads the torque is that at `radial_load`
/// [N], straight between them. Throws InputError: a column or a point of the grid that is missing,
/// a point twice, cells that are no numbers, a radial load that is not given or beyond the table.
[[nodiscard]] correction::FrictionTable parse_friction_table(std::string text,
                                                             const std::string& source,
                                                             double radial_load = unset);

/// Two columns, "power_W" and `value` (in a unit of its kind), power rising: a gain or a time
/// constant over the power loss, SI.
[[nodiscard]] correction::Characteristic::Table parse_characteristic(std::string text,
                                                                     const std::string& source,
                                                                     const std::string& value);

}  // namespace raceway::files
