#include "report/report_template.h"

namespace raceway::report {

std::string_view report_template() { return {}; }

}  // namespace raceway::report
