#pragma once

#include <string>
#include <vector>

#include "cli/number_flag.h"

namespace raceway::cli {

/// Values of a flag, growing: "100,300,900", "0:12000:250" (from:to:step), or both:
/// "0,100:500:100". Throws text::InputError.
[[nodiscard]] std::vector<double> axis(const std::string& text, const std::string& flag);

/// Throws text::InputError for the first value outside the range.
void require_all(const std::vector<double>& values, const NumberRange& range,
                 const std::string& flag);

}  // namespace raceway::cli
