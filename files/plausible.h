#pragma once

#include <string>
#include <string_view>

#include "bearing/geometry.h"

/// What a number is, where it lies in its range but not where such a number lies: one line for the
/// user, empty where nothing is strange.
namespace raceway::files {

/// A temperature in C that would be a usual one in K.
[[nodiscard]] std::string looks_like_kelvin(std::string_view name, double temperature_C);

/// Balls so small that their circle is almost empty, or their rating far beyond what such balls can
/// carry, and right if the numbers were inches.
[[nodiscard]] std::string looks_like_inches(const bearing::BearingGeometry& geometry);

}  // namespace raceway::files
