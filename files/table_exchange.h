#pragma once

#include <string>
#include <string_view>

#include "friction/stribeck_table.h"

/// Writers of Stribeck tables for other programs. The files are not read back.
namespace raceway::files {

/// CSV with one header line and names that are identifiers (spin_friction_Nmm), so that pandas and
/// MATLAB read it without options; otherwise as table_text(). A point without value has NaN, which
/// both take for a number.
[[nodiscard]] std::string plain_table_text(const friction::StribeckTable& table);

/// The friction torque as a text file for Modelica.Blocks.Tables.CombiTable2Ds, in SI as Modelica
/// has it: u1 the speed [rad/s], u2 the axial load [N], y the torque [N m]. One table for each
/// radial load and temperature, `friction_torque` where there is one, else
/// `friction_torque_Fr0_T313` (N, K); a table of one load is for CombiTable1Ds, columns speed and
/// torque. Throws InputError for a slab and where a point has no value.
[[nodiscard]] std::string modelica_table_text(const friction::StribeckTable& table,
                                              std::string_view title);

}  // namespace raceway::files
