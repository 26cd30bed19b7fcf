#include "cli/number_flag.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "record/units.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/units.h"

namespace raceway::cli {
namespace {

double number_of(const std::string& number, const std::string& shown, const NumberRange& range,
                 const std::string& flag) {
  const text::ParsedNumber parsed = text::parse_number(number, true);
  if (!parsed.problem.empty() || parsed.decimal_mark == ',')
    throw text::InputError(
        fmt::format(
            "{} = {}: {}; {}", flag, text::quoted(shown),
            parsed.problem.empty() ? "has a decimal comma; write a decimal point" : parsed.problem,
            text::range_text(range)),
        {.key = flag});
  return parsed.value;
}

}  // namespace

void ask_about_thousands(std::span<const std::string_view> numbers, const NumberRange& range,
                         const std::string& flag) {
  if (!text::may_have_thousands(numbers)) return;
  const std::string_view number = *std::find_if(
      numbers.begin(), numbers.end(), [](std::string_view n) { return n.find('.') != n.npos; });
  std::string plain(number);
  std::erase(plain, '.');
  if (const double value = text::parse_number(plain, false).value;
      value < range.lower || value > range.upper)
    return;
  throw text::InputError(fmt::format("{} = {}: is it {}, or is the point a decimal mark? Write {} "
                                     "or {}0",
                                     flag, number, plain, plain, number),
                         {.key = flag});
}

CLI::Option* add_number(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help) {
  const auto take = [&value, range, flag](const std::string& text) {
    ask_about_thousands(std::array{std::string_view(text)}, range, flag);
    value = number_of(text, text, range, flag);
    require_range(value, range, flag);
  };
  return command.add_option_function<std::string>(flag, take, help)->type_name("NUMBER");
}

CLI::Option* add_length(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help) {
  const auto take = [&value, range, flag](const std::string& text) {
    const std::size_t end = std::min(text.find_last_of("0123456789.,") + 1, text.size());
    const text::Unit* const unit = end == text.size()
                                       ? text::find_unit("mm")
                                       : text::find_unit(text.substr(end), text::Dimension::length);
    if (!unit)
      throw text::InputError(fmt::format("{} = {}: not a number with a unit of length; write 70mm, "
                                         "2.7559in, or millimetres without unit",
                                         flag, text::quoted(text)),
                             {.key = flag});
    value = unit->to_SI(number_of(text.substr(0, end), text, range, flag));
    require_range(value / mm, range, flag);
  };
  return command.add_option_function<std::string>(flag, take, help)->type_name("LENGTH");
}

}  // namespace raceway::cli
