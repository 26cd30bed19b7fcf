#pragma once

#include <string>
#include <string_view>

#include "bearing/geometry.h"

/// Checks values that are allowed but unlikely. Each function returns one line that states the
/// likely cause, or an empty text for a usual value.
namespace raceway::files {

/// Checks whether a temperature is unlikely in C but usual in K.
[[nodiscard]] std::string looks_like_kelvin(std::string_view name, double temperature_C);

/// Checks whether lengths of a bearing are in inches. The ball diameter is probably in inches if
/// the balls fill a far too small fraction of the pitch circle. All lengths are probably in inches
/// if the load rating is far too high for the size of the balls. In both cases, the text is empty
/// unless the lengths, converted from inches, give a usual fraction or rating.
[[nodiscard]] std::string looks_like_inches(const bearing::BearingGeometry& geometry);

}  // namespace raceway::files
