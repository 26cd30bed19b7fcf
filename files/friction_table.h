#pragma once

#include <string>

#include "correction/characteristic.h"
#include "correction/friction_table.h"
#include "friction/torque_table.h"

namespace raceway::files {

/// Reads a friction table of a bearing or a spindle, from `raceway table` or from a rig. The
/// columns of the table are speed_rpm, axial_load_N, radial_load_N, temperature_C and
/// friction_torque_Nmm, or the same columns in other units. If the file has no column for a load or
/// for the temperature, the torque does not depend on this quantity. The band of the torque may be
/// in friction_torque_band_Nmm (half width, 95 %) or std_Nmm (standard deviation), and the
/// load-dependent part of the torque in load_Nmm. Further columns are allowed. Throws InputError if
/// the speed, the torque or a point of the grid is missing, if a point occurs twice, for two
/// columns with a band, for a slab of a table, and for cells that are not numbers.
[[nodiscard]] friction::TorqueTable parse_friction_table(std::string text,
                                                         const std::string& source);

/// Converts a friction table to the form that corrections use.
[[nodiscard]] correction::FrictionTable of_correction(friction::TorqueTable table);

/// Input of a table of gains or time constants: "power" from "power_W", or a column of a record.
struct CurveInput {
  std::string column, variable;
  double unit = 1.0;  ///< SI value of one unit of the column
};

/// Reads a gain or a time constant [SI] as a function of a power or a load. The table has two
/// columns: the input, with rising values, and the quantity `value`. The names of both columns end
/// in their units.
[[nodiscard]] correction::Characteristic::Table parse_characteristic(std::string text,
                                                                     const std::string& source,
                                                                     const std::string& value,
                                                                     const CurveInput& input);

}  // namespace raceway::files
