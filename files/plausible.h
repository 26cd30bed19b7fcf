#pragma once

#include <string>
#include <string_view>

#include "bearing/geometry.h"

/// Checks for numbers that lie in their range but are unlikely: one line for the user with the
/// likely meaning, empty for a usual number.
namespace raceway::files {

/// A temperature in C that would be a usual one in K.
[[nodiscard]] std::string looks_like_kelvin(std::string_view name, double temperature_C);

/// Balls so small that their circle is almost empty, or their rating far beyond what such balls can
/// carry, and right if the numbers were inches.
[[nodiscard]] std::string looks_like_inches(const bearing::BearingGeometry& geometry);

}  // namespace raceway::files
