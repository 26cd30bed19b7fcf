#pragma once

#include <array>
#include <string_view>

/// Column names in the file of a Stribeck table, and the mark of a slab (a file with only some
/// points of the grid). The writer and the reader of the file use them.
namespace raceway::files {

inline constexpr std::array<std::string_view, 5> leading_columns{
    "speed_rpm", "axial_load_N", "radial_load_N", "temperature_C", "friction_torque_Nmm"};
inline constexpr std::string_view status_column = "status";
inline constexpr std::string_view slab_mark = "# slab ";

}  // namespace raceway::files
