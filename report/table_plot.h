#pragma once

#include <string>
#include <string_view>

#include "friction/stribeck_table.h"

namespace raceway::report {

/// Friction torque over speed as an SVG picture: a curve for each axial load, or for each
/// temperature where there is one load, at the first value of all other axes. A point without value
/// is a gap. Throws InputError where no point has a value, and for a slab.
[[nodiscard]] std::string table_svg(const friction::StribeckTable& table, std::string_view title);

}  // namespace raceway::report
