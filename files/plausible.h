#pragma once

#include <string>
#include <string_view>

#include "bearing/geometry.h"

/// Finds values that are allowed but unlikely, such as a temperature in the wrong unit. Each
/// function returns one line that states the likely cause, or an empty text for a usual value.
namespace raceway::files {

/// Checks if a temperature in C is unlikely, and would be usual if the number were in K.
[[nodiscard]] std::string looks_like_kelvin(std::string_view name, double temperature_C);

/// Checks if the lengths of a bearing are probably in inches. In two cases, a conversion from
/// inches makes an unlikely value usual. In the first case, the balls fill a far too small part of
/// the pitch circle, so the ball diameter is probably in inches. In the second case, the static
/// load rating is far too high for the size of the balls, so all lengths are probably in inches.
[[nodiscard]] std::string looks_like_inches(const bearing::BearingGeometry& geometry);

}  // namespace raceway::files
