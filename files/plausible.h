#pragma once

#include <string>
#include <string_view>

#include "bearing/geometry.h"

/// Checks values that are allowed but unlikely. Each function returns one line that states the
/// likely cause, or an empty text for a usual value.
namespace raceway::files {

/// Checks whether a temperature is unlikely in C but usual in K.
[[nodiscard]] std::string looks_like_kelvin(std::string_view name, double temperature_C);

/// Checks whether the lengths of a bearing are in inches. The test uses the fraction of the pitch
/// circle that the balls fill, and the ratio of the load rating to the size of the balls. Lengths
/// look like inches if the fraction is far too low or the ratio is far too high, and if this value
/// would be usual with lengths in inches.
[[nodiscard]] std::string looks_like_inches(const bearing::BearingGeometry& geometry);

}  // namespace raceway::files
