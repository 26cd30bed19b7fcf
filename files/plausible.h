#pragma once

#include <string>
#include <string_view>

#include "bearing/geometry.h"

/// Finds values that are allowed but unlikely, such as a temperature in the wrong unit. Each
/// function returns one line that states the likely cause, or an empty text for a usual value.
namespace raceway::files {

/// Checks if a temperature in C is unlikely, but would be usual if the number were in K.
[[nodiscard]] std::string looks_like_kelvin(std::string_view name, double temperature_C);

/// Checks if lengths of a bearing are probably in inches. If the balls fill a far too small part of
/// the pitch circle, the ball diameter is probably in inches. If the static load rating is far too
/// high for the size of the balls, all lengths are probably in inches. The result is empty if the
/// conversion of these lengths from inches to mm would not give a usual bearing.
[[nodiscard]] std::string looks_like_inches(const bearing::BearingGeometry& geometry);

}  // namespace raceway::files
