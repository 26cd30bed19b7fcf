#pragma once

#include <string>
#include <string_view>

#include "friction/stribeck_table.h"

/// Writers of Stribeck tables for other programs. Raceway does not read these files.
namespace raceway::files {

/// Returns a table as CSV with one header line. The column names are valid identifiers
/// (spin_friction_Nmm). pandas and MATLAB read the file without options. A point without a value
/// has NaN, which both programs read as a number. Everything else is as in table_text().
[[nodiscard]] std::string plain_table_text(const friction::StribeckTable& table);

/// Returns the friction torque as a text file for Modelica.Blocks.Tables.CombiTable2Ds, in SI: u1
/// is the speed [rad/s], u2 the axial load [N], y the torque [N m]. The file has a table for each
/// radial load and temperature. The name of a single table is `friction_torque`. Several tables
/// have names such as `friction_torque_Fr0_T313` (N, K). A table with only one axial load is for
/// CombiTable1Ds, with the columns speed and torque. Throws InputError for a slab, and for a point
/// without a value.
[[nodiscard]] std::string modelica_table_text(const friction::StribeckTable& table,
                                              std::string_view title);

}  // namespace raceway::files
