#pragma once

#include <string_view>

namespace raceway::report {

/// Returns the HTML text of report/page/, bundled at build time, with a placeholder for the report
/// document. The text is empty in a program that was built with -DRACEWAY_REPORT=OFF.
[[nodiscard]] std::string_view report_template();

}  // namespace raceway::report
