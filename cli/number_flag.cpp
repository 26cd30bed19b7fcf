#include "cli/number_flag.h"

#include <fmt/format.h>

#include "io/csv.h"
#include "io/error.h"

namespace raceway::cli {
namespace {

std::string range_text(const NumberRange& range) {
  return fmt::format("must be from {:.10g} to {:.10g} {}", range.lower, range.upper, range.unit);
}

}  // namespace

void require_range(double value, const NumberRange& range, const std::string& flag) {
  if (value >= range.lower && value <= range.upper) return;
  throw io::InputError(
      fmt::format("{} = {:.10g} {}: {}", flag, value, range.unit, range_text(range)));
}

CLI::Option* add_number(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help) {
  const auto take = [&value, range, flag](const std::string& text) {
    const io::ParsedNumber number = io::parse_number(text, true);
    if (!number.problem.empty() || number.decimal_mark == ',')
      throw io::InputError(fmt::format(
          "{} = {}: {}; {}", flag, io::quoted(text),
          number.problem.empty() ? "has a decimal comma, a point is expected" : number.problem,
          range_text(range)));
    require_range(number.value, range, flag);
    value = number.value;
  };
  return command.add_option_function<std::string>(flag, take, help)->type_name("NUMBER");
}

}  // namespace raceway::cli
