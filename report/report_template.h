#pragma once

#include <string_view>

namespace raceway::report {

/// Page of report/page/, bundled at build time, with a mark for the document. Empty in a program
/// built with -DRACEWAY_REPORT=OFF.
[[nodiscard]] std::string_view report_template();

}  // namespace raceway::report
