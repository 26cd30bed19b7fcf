#pragma once

#include <string>
#include <string_view>

#include "friction/stribeck_table.h"

namespace raceway::report {

/// Returns the friction torque of a table over speed as an SVG picture. The picture has a curve for
/// each axial load. If the table has only one axial load, the picture has a curve for each
/// temperature. Of the inputs without curves, such as the radial load, the picture uses only the
/// first value. A point without a torque is a gap in the curve. Throws InputError if no point has a
/// torque above 0, and if the table is only a part (slab) of a larger table.
[[nodiscard]] std::string table_svg(const friction::StribeckTable& table, std::string_view title);

}  // namespace raceway::report
