#include "record/digits.h"

#include <array>
#include <charconv>
#include <cmath>

namespace raceway::record {

double with_digits(double value, int digits) {
  if (!std::isfinite(value)) return value;
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::scientific, digits - 1);
  double rounded = value;
  const auto read = std::from_chars(text.data(), written.ptr, rounded);
  return read.ec == std::errc() ? rounded : value;
}

}  // namespace raceway::record
