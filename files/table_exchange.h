#pragma once

#include <string>
#include <string_view>

#include "friction/stribeck_table.h"

/// Writes Stribeck tables for other programs. Raceway cannot read these files.
namespace raceway::files {

/// Returns a table as CSV text with one header line and with column names that are valid
/// identifiers (spin_friction_Nmm). The programs pandas and MATLAB read this CSV text without
/// options. A point without a solution has the value NaN, which both programs can read.
/// Columns and units are as in table_text().
[[nodiscard]] std::string plain_table_text(const friction::StribeckTable& table);

/// Returns the friction torque as a text file for Modelica.Blocks.Tables.CombiTable2Ds, in SI: u1
/// is the speed [rad/s], u2 is the axial load [N], and y is the torque [N m]. The text has one
/// table for each radial load and temperature. If there is only one table, its name is
/// `friction_torque`. Otherwise, the name of each table contains its radial load in N and its
/// temperature in K, such as `friction_torque_Fr0_T313_15`. If there is only one axial load, the
/// tables are for CombiTable1Ds, with the columns speed and torque. Throws InputError for a slab (a
/// part of a table, see table_file.h), and for a point without a value.
[[nodiscard]] std::string modelica_table_text(const friction::StribeckTable& table,
                                              std::string_view title);

}  // namespace raceway::files
