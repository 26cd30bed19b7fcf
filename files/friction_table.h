#pragma once

#include <string>

#include "correction/characteristic.h"
#include "correction/friction_table.h"
#include "friction/torque_table.h"

namespace raceway::files {

/// Reads a friction table of a bearing or a spindle: columns speed_rpm, axial_load_N,
/// radial_load_N, temperature_C and friction_torque_Nmm, also in other units, as `raceway table`
/// writes them or as a rig gives them. A load or a temperature without a column is one for all. The
/// band of the torque is friction_torque_band_Nmm (half width, 95 %) or std_Nmm (standard
/// deviation), its part by the load load_Nmm; further columns are allowed. Throws InputError: a
/// column or a point of the grid that is missing, a point twice, cells that are no numbers.
[[nodiscard]] friction::TorqueTable parse_friction_table(std::string text,
                                                         const std::string& source);

/// Returns the torques of a table in the form of a correction.
[[nodiscard]] correction::FrictionTable of_correction(friction::TorqueTable table);

/// Input of a table of gains or time constants: "power" of "power_W", or a column of a record.
struct CurveInput {
  std::string column, variable;
  double unit = 1.0;  ///< unit of the column [SI]
};

/// Two columns, the input, rising, and `value` (in a unit of its kind): a gain or a time constant
/// [SI] over a power or a load, in the unit of its column.
[[nodiscard]] correction::Characteristic::Table parse_characteristic(std::string text,
                                                                     const std::string& source,
                                                                     const std::string& value,
                                                                     const CurveInput& input);

}  // namespace raceway::files
