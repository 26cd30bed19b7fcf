#include "text/number_range.h"

#include <fmt/format.h>

#include "text/error.h"

namespace raceway::text {

std::string range_text(const NumberRange& range) {
  return fmt::format("must be from {:.10g} to {:.10g} {}", range.lower, range.upper, range.unit);
}

void require_range(double value, const NumberRange& range, const std::string& name) {
  if (value >= range.lower && value <= range.upper) return;
  throw InputError(fmt::format("{} = {:.10g} {}: {}", name, value, range.unit, range_text(range)),
                   {.key = name});
}

}  // namespace raceway::text
