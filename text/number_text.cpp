#include "text/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "record/digits.h"

namespace raceway::text {

double with_15_digits(double value) { return record::with_digits(value, 15); }

std::string toml_float(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == text.npos) text += ".0";
  return text;
}

std::string number(double value, int digits) {
  if (std::isnan(value)) return "-";
  if (value == 0.0 || std::isinf(value)) return fmt::format("{:g}", value + 0.0);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (magnitude < -4 || magnitude > 7) return fmt::format("{:.{}e}", value, digits - 1);
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - magnitude));
}

double value_in_unit(const record::Channel& channel, double si) {
  const double value = channel.in_unit(si);
  constexpr double digits = 1e9;
  return channel.offset == 0.0 ? value : std::round(value * digits) / digits;
}

std::string_view difference_unit(const record::Channel& channel) {
  return channel.offset == 0.0 ? channel.key_unit() : "K";
}

std::string tolerance_key(const record::Channel& channel) {
  return "tolerance_" + std::string(difference_unit(channel));
}

}  // namespace raceway::text
