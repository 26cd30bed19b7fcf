#pragma once

#include <string>

#include "correction/characteristic.h"
#include "correction/friction_table.h"
#include "friction/torque_table.h"

namespace raceway::files {

/// Reads a friction table of a bearing or a spindle, from `raceway table` or from a rig. Its
/// columns are speed_rpm, axial_load_N, radial_load_N, temperature_C and friction_torque_Nmm, or
/// the same columns in other units. A load or a temperature without a column has the same value at
/// all points. The band of the torque may be in friction_torque_band_Nmm (half width, 95 %) or
/// std_Nmm (standard deviation), and the load-dependent part of the torque in load_Nmm. Further
/// columns are allowed. Throws InputError if a column or a point of the grid is missing, if a point
/// occurs twice, and for cells that are not numbers.
[[nodiscard]] friction::TorqueTable parse_friction_table(std::string text,
                                                         const std::string& source);

/// Returns the torques of a table in the form of a correction.
[[nodiscard]] correction::FrictionTable of_correction(friction::TorqueTable table);

/// Input of a table of gains or time constants: "power" from "power_W", or a column of a record.
struct CurveInput {
  std::string column, variable;
  double unit = 1.0;  ///< unit of the column [SI]
};

/// Reads a gain or a time constant [SI] as a function of a power or a load. The table has two
/// columns: the input, with rising values in the unit of its column name, and `value`, in a unit of
/// a gain or of a time.
[[nodiscard]] correction::Characteristic::Table parse_characteristic(std::string text,
                                                                     const std::string& source,
                                                                     const std::string& value,
                                                                     const CurveInput& input);

}  // namespace raceway::files
