#pragma once

#include <string>
#include <string_view>

#include "bearing/geometry.h"

/// Checks for unlikely numbers within their range. Each function returns one line with the likely
/// meaning, or an empty text for a usual number.
namespace raceway::files {

/// Checks a temperature in C that would be usual in K.
[[nodiscard]] std::string looks_like_kelvin(std::string_view name, double temperature_C);

/// Checks for lengths in inches. Two values are tested: the share of the pitch circle that the
/// balls fill, and the rating compared with the size of the balls. Lengths look like inches if the
/// share is far too low or the rating is far too high, and if the same value would be usual with
/// lengths in inches.
[[nodiscard]] std::string looks_like_inches(const bearing::BearingGeometry& geometry);

}  // namespace raceway::files
