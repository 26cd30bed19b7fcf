#include "text/twelve_digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace raceway::text {
namespace {

constexpr int digits = 12;
constexpr int lowest_exponent = -4, highest_exponent = digits - 1;  // written without exponent

/// Powers of ten are exact up to 1e22.
constexpr auto powers = [] {
  std::array<double, digits - lowest_exponent + 1> list{};
  double power = 1.0;
  for (double& p : list) {
    p = power;
    power *= 10.0;
  }
  return list;
}();

/// A value as 12 digits and the power of ten of the first; no digits where rounding is in doubt.
struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
};

Decimal decimal(double value) {
  constexpr double lowest = 1e11, beyond = 1e12;
  int exponent = 0;
  std::frexp(value, &exponent);
  exponent = static_cast<int>(std::floor((exponent - 1) * 0.30102999566398120));
  exponent = std::clamp(exponent, lowest_exponent, highest_exponent);
  const auto scaled_by = [&](int e) {
    return value * powers[static_cast<std::size_t>(highest_exponent - e)];
  };
  double scaled = scaled_by(exponent);
  if (scaled >= beyond && exponent < highest_exponent) scaled = scaled_by(++exponent);
  if (!(scaled >= lowest && scaled < beyond)) return {};
  const auto whole = static_cast<std::uint64_t>(scaled);
  const double rest = scaled - static_cast<double>(whole);
  constexpr double doubt = 1e-3;  // the product is good to 6e-5
  if (std::abs(rest - 0.5) < doubt) return {};
  const std::uint64_t rounded = whole + (rest > 0.5 ? 1 : 0);
  return rounded < static_cast<std::uint64_t>(beyond) ? Decimal{rounded, exponent} : Decimal{};
}

}  // namespace

char* write_12_digits(char* out, double value) {
  const Decimal d = decimal(std::abs(value));
  if (d.digits == 0)
    return std::to_chars(out, out + twelve_digits_room, value, std::chars_format::general, digits)
        .ptr;
  std::array<char, digits> text{};
  std::to_chars(text.data(), text.data() + digits, d.digits);
  int count = digits;
  while (text[static_cast<std::size_t>(count - 1)] == '0') --count;
  if (value < 0.0) *out++ = '-';
  if (d.exponent < 0) {
    *out++ = '0';
    *out++ = '.';
    out = std::fill_n(out, -d.exponent - 1, '0');
    return std::copy_n(text.data(), count, out);
  }
  const int whole = d.exponent + 1;
  out = std::copy_n(text.data(), whole, out);
  if (count <= whole) return out;
  *out++ = '.';
  return std::copy(text.data() + whole, text.data() + count, out);
}

}  // namespace raceway::text
