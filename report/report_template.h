#pragma once

#include <string_view>

namespace raceway::report {

/// The page of report/page/, bundled at build time, with a mark where the document goes; empty in a
/// program built with -DRACEWAY_REPORT=OFF.
[[nodiscard]] std::string_view report_template();

}  // namespace raceway::report
