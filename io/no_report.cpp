#include "io/report_template.h"

namespace raceway::io {

std::string_view report_template() { return {}; }

}  // namespace raceway::io
