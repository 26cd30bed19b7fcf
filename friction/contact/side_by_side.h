#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>
#include <type_traits>

/// Elementary functions without a branch or a call, so that a compiler can make several at once.
/// Part of slip_forces.cpp, not for other code; film_traction.cpp has its own, for vectors.
namespace raceway::friction::contact {

/// ln(1 + t) for t >= 0, to 2e-16 relative in double and 2e-7 in float, as 2 atanh(s) of the
/// mantissa. A small t keeps its digits.
template <std::floating_point Real>
[[gnu::always_inline]] inline Real log_one_plus(Real t) {
  constexpr bool wide = std::is_same_v<Real, double>;
  using Bits = std::conditional_t<wide, std::uint64_t, std::uint32_t>;
  constexpr int digits = wide ? 52 : 23;
  constexpr Bits mantissa = (Bits{1} << digits) - 1, one = std::bit_cast<Bits>(Real(1));
  // 2^digits, whose last digits count units.
  constexpr auto unit = static_cast<Real>(Bits{1} << digits);
  constexpr Bits whole = std::bit_cast<Bits>(unit);
  constexpr Real bias = unit + Real(wide ? 1023 : 127);
  const auto bits = std::bit_cast<Bits>(Real(1) + t);
  const Real m = std::bit_cast<Real>((bits & mantissa) | one);
  const Real exponent = std::bit_cast<Real>((bits >> digits) | whole) - bias;
  const bool upper = m > std::numbers::sqrt2_v<Real>;
  const Real reduced = upper ? Real(0.5) * m : m;
  const bool small = t < std::numbers::sqrt2_v<Real> - Real(1);
  const Real scale = small ? Real(0) : (upper ? exponent + Real(1) : exponent);
  const Real s = (small ? t : reduced - Real(1)) / (small ? t + Real(2) : reduced + Real(1));
  const Real q = s * s;
  // 1 + q/3 + ... + q^9/19, written out: a loop here would keep the points from going side by side.
  Real series = 0;
  if constexpr (wide) {
    series = 1.0 / 17.0 + q / 19.0;
    series = 1.0 / 13.0 + q * (1.0 / 15.0 + q * series);
    series = 1.0 / 9.0 + q * (1.0 / 11.0 + q * series);
    series = 1.0 / 5.0 + q * (1.0 / 7.0 + q * series);
    series = 1.0 + q * (1.0 / 3.0 + q * series);
  } else {
    series = 1.0f / 7.0f + q * (1.0f / 9.0f);
    series = 1.0f + q * (1.0f / 3.0f + q * (1.0f / 5.0f + q * series));
  }
  return scale * std::numbers::ln2_v<Real> + Real(2) * s * series;
}

/// asinh(x) for x >= 0 whose sqrt(1 + x²) is `length`: ln(1 + t), t = x + x²/(1 + length).
template <std::floating_point Real>
[[gnu::always_inline]] inline Real area_sine(Real x, Real length) {
  return log_one_plus(x + x * x / (Real(1) + length));
}

}  // namespace raceway::friction::contact
