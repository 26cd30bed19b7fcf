#include "cli/axis_flag.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "text/csv.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

double one_number(std::string_view text, const std::string& flag) {
  const text::ParsedNumber n = text::parse_number(text, false);
  if (!n.problem.empty())
    throw text::InputError(fmt::format("{}: {} {}; write 100,300,900 or 0:12000:250 (from:to:step)",
                                       flag, text::quoted(text), n.problem),
                           {.key = flag});
  return n.value;
}

/// The numbers of a list of values and ranges, as they are written.
std::vector<std::string_view> numbers_in(std::string_view text) {
  std::vector<std::string_view> list;
  for (const std::string_view item : text::split(text, ','))
    for (const std::string_view number : text::split(item, ':')) list.push_back(number);
  return list;
}

}  // namespace

std::vector<double> axis(const std::string& text, const NumberRange& range,
                         const std::string& flag) {
  ask_about_thousands(numbers_in(text), range, flag);
  std::vector<double> values;
  for (const std::string_view item : text::split(text, ',')) {
    const std::size_t first = item.find(':');
    if (first == std::string_view::npos) {
      values.push_back(one_number(item, flag));
      continue;
    }
    const std::size_t second = item.find(':', first + 1);
    if (second == std::string_view::npos)
      throw text::InputError(
          flag + ": " + text::quoted(item) + ": write a range as from:to:step, such as 0:12000:250",
          {.key = flag});
    const double from = one_number(item.substr(0, first), flag);
    const double to = one_number(item.substr(first + 1, second - first - 1), flag);
    const double step = one_number(item.substr(second + 1), flag);
    if (!(step > 0.0) || to < from)
      throw text::InputError(
          flag + ": " + text::quoted(item) +
              ": the end of a range must not be below its start, and the step must be above 0",
          {.key = flag});
    const double count = std::floor((to - from) / step * (1.0 + 1e-12) + 1e-9);
    if (count + static_cast<double>(values.size()) > 1e7)
      throw text::InputError(flag + ": " + text::quoted(item) +
                                 ": the range has more than ten million values; use a larger step",
                             {.key = flag});
    for (double i = 0.0; i <= count; i += 1.0) values.push_back(from + i * step);
  }
  if (!std::is_sorted(values.begin(), values.end()) ||
      std::adjacent_find(values.begin(), values.end()) != values.end())
    throw text::InputError(flag + ": " + text::quoted(text) +
                               ": the values must be in ascending order, without duplicates; a "
                               "comma separates values, and decimals have a point",
                           {.key = flag});
  return values;
}

void AxisFlags::declare(CLI::App& command, const std::string& speed_help) {
  command.add_option("--speed", speed, speed_help)->required()->type_name("VALUES");
  command
      .add_option(
          "--axial-load", axial_load,
          "axial load [N] (of a shaft: positive towards the tool); default: axial_load_N or "
          "external_load_N of the model")
      ->type_name("VALUES");
  command
      .add_option("--radial-load", radial_load,
                  "radial load [N]; default: [rig] of the model, else 0")
      ->type_name("VALUES");
  command
      .add_option("--temperature", temperature,
                  "lubricant temperature [C]; default: [rig] of the model, else 40")
      ->type_name("VALUES");
}

session::AskedAxes AxisFlags::asked() const {
  const auto values = [](const std::string& text, const NumberRange& range, const char* flag) {
    return text.empty() ? std::vector<double>() : axis(text, range, flag);
  };
  return {.speed_rpm = values(speed, speed_range, "--speed"),
          .axial_load_N = values(axial_load, signed_load_range, "--axial-load"),
          .radial_load_N = values(radial_load, load_range, "--radial-load"),
          .temperature_C = values(temperature, temperature_range, "--temperature")};
}

void require_all(const std::vector<double>& values, const NumberRange& range,
                 const std::string& flag) {
  for (const double value : values) require_range(value, range, flag);
}

}  // namespace raceway::cli
