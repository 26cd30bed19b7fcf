#pragma once

#include <string>
#include <string_view>

#include "friction/stribeck_table.h"

namespace raceway::report {

/// Returns the friction torque over speed as an SVG picture. The picture has a curve for each axial
/// load. If there is only one load, the picture has a curve for each temperature. All other axes
/// are fixed at their first value. A point without a value is a gap in the curve. Throws InputError
/// if no point has a value, and for a slab.
[[nodiscard]] std::string table_svg(const friction::StribeckTable& table, std::string_view title);

}  // namespace raceway::report
