#pragma once

#include <string>

#include "correction/characteristic.h"
#include "correction/friction_table.h"
#include "friction/torque_table.h"

namespace raceway::files {

/// Parses a table of the friction torque of a bearing or a spindle, computed by `raceway table` or
/// measured on a rig. The columns of the table are speed_rpm, axial_load_N, radial_load_N,
/// temperature_C and friction_torque_Nmm, or these quantities in other units. If the file has no
/// column for a load or for the temperature, the torque is assumed independent of this quantity.
/// The uncertainty of the torque may be in friction_torque_band_Nmm (half width of a 95 % band) or
/// std_Nmm (standard deviation), and the load-dependent torque in load_Nmm. Other columns are
/// allowed. Throws InputError if the column of the speed or the torque is missing, if a point of
/// the grid is missing or occurs twice, if the table has both columns of uncertainty, and for cells
/// that are not numbers. Also throws InputError for a slab (a part of a table, see table_file.h).
[[nodiscard]] friction::TorqueTable parse_friction_table(std::string text,
                                                         const std::string& source);

/// Converts a friction table to the type of table from which a correction calculates the friction
/// power.
[[nodiscard]] correction::FrictionTable of_correction(friction::TorqueTable table);

/// Independent variable of a table of gains or time constants: the friction power (column
/// "power_W", variable "power") or a load. For a load, both names are as in a record.
struct CurveInput {
  std::string column, variable;
  double unit = 1.0;  ///< factor from the unit of the column to SI
};

/// Parses a table of a gain or a time constant as a function of a power or a load, and converts the
/// table to SI. One column contains the power or load, in ascending order. Another column contains
/// the gain or time constant, and its name begins with the argument `value`. Both column names end
/// with a unit. Other columns are ignored.
[[nodiscard]] correction::Characteristic::Table parse_characteristic(std::string text,
                                                                     const std::string& source,
                                                                     const std::string& value,
                                                                     const CurveInput& input);

}  // namespace raceway::files
