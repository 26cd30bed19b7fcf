#pragma once

#include <string>
#include <string_view>

#include "bearing/geometry.h"

/// Checks for unlikely numbers within their range. Each returns one line with the likely meaning;
/// empty for a usual number.
namespace raceway::files {

/// Checks a temperature in C that would be usual in K.
[[nodiscard]] std::string looks_like_kelvin(std::string_view name, double temperature_C);

/// Checks for balls so small that their circle is almost empty, or that the rating far exceeds
/// them, with numbers that would be right in inches.
[[nodiscard]] std::string looks_like_inches(const bearing::BearingGeometry& geometry);

}  // namespace raceway::files
