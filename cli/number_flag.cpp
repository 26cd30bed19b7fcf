#include "cli/number_flag.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/csv.h"
#include "io/error.h"
#include "io/units.h"
#include "record/units.h"

namespace raceway::cli {
namespace {

double number_of(const std::string& number, const std::string& shown, const NumberRange& range,
                 const std::string& flag) {
  const io::ParsedNumber parsed = io::parse_number(number, true);
  if (!parsed.problem.empty() || parsed.decimal_mark == ',')
    throw io::InputError(
        fmt::format(
            "{} = {}: {}; {}", flag, io::quoted(shown),
            parsed.problem.empty() ? "has a decimal comma, a point is expected" : parsed.problem,
            io::range_text(range)),
        {.key = flag});
  return parsed.value;
}

}  // namespace

CLI::Option* add_number(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help) {
  const auto take = [&value, range, flag](const std::string& text) {
    value = number_of(text, text, range, flag);
    require_range(value, range, flag);
  };
  return command.add_option_function<std::string>(flag, take, help)->type_name("NUMBER");
}

CLI::Option* add_length(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help) {
  const auto take = [&value, range, flag](const std::string& text) {
    const std::size_t end = std::min(text.find_last_of("0123456789.,") + 1, text.size());
    const io::Unit* const unit = end == text.size()
                                     ? io::find_unit("mm")
                                     : io::find_unit(text.substr(end), io::Dimension::length);
    if (!unit)
      throw io::InputError(
          fmt::format("{} = {}: no unit of length behind the number; write 70mm, 2.7559in or "
                      "millimetres without unit",
                      flag, io::quoted(text)),
          {.key = flag});
    value = unit->to_SI(number_of(text.substr(0, end), text, range, flag));
    require_range(value / mm, range, flag);
  };
  return command.add_option_function<std::string>(flag, take, help)->type_name("LENGTH");
}

}  // namespace raceway::cli
