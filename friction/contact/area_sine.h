#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

namespace raceway::friction::contact {

/// Returns asinh(x) for x >= 0 with a relative error of 1e-15. A compiler can vectorize this code.
/// The argument `length` is sqrt(1 + x²).
[[gnu::always_inline]] inline double area_sine(double x, double length) {
  const double t = x + x * x / (1.0 + length);
  const auto bits = std::bit_cast<std::uint64_t>(1.0 + t);
  constexpr std::uint64_t mantissa = 0x000fffffffffffff, one = 0x3ff0000000000000;
  constexpr std::uint64_t whole = 0x4330000000000000;  // 2^52; its last digit has the value 1
  const double m = std::bit_cast<double>((bits & mantissa) | one);
  const double exponent =
      std::bit_cast<double>((bits >> 52) | whole) - (4503599627370496.0 + 1023.0);
  const bool upper = m > std::numbers::sqrt2;
  const double reduced = upper ? 0.5 * m : m;
  const bool small = t < std::numbers::sqrt2 - 1.0;  // keeps the digits of a small t
  const double scale = small ? 0.0 : (upper ? exponent + 1.0 : exponent);
  const double s = (small ? t : reduced - 1.0) / (small ? t + 2.0 : reduced + 1.0);
  const double q = s * s;
  // The series 1 + q/3 + ... + q^9/19 is written out, because a loop would prevent vectorization.
  double series = 1.0 / 17.0 + q / 19.0;
  series = 1.0 / 13.0 + q * (1.0 / 15.0 + q * series);
  series = 1.0 / 9.0 + q * (1.0 / 11.0 + q * series);
  series = 1.0 / 5.0 + q * (1.0 / 7.0 + q * series);
  series = 1.0 + q * (1.0 / 3.0 + q * series);
  return scale * std::numbers::ln2 + 2.0 * s * series;
}

}  // namespace raceway::friction::contact
