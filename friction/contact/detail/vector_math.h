#pragma once

#include <xsimd/xsimd.hpp>

// Vector functions for sources that are compiled for one instruction set each. The linker must not
// merge code compiled for different sets, so each function is templated on V or always inlined.
namespace raceway::friction::contact {

template <class V>
inline constexpr bool is_double = sizeof(typename V::value_type) == 8;

/// Returns an estimate of 1/sqrt(x), accurate to 12 bits or more.
template <class V>
[[gnu::always_inline]] inline V estimated_inverse_root(const V& x) {
#ifdef __AVX512F__
  // For this type, xsimd 8 uses instructions that not all machines with AVX-512 have.
  if constexpr (sizeof(V) == 64 && is_double<V>)
    return V(_mm512_rsqrt14_pd(x));
  else if constexpr (sizeof(V) == 64)
    return V(_mm512_rsqrt14_ps(x));
  else
#endif
    return xsimd::rsqrt(x);
}

/// Returns 1/sqrt(x) for x from 1e-36 to 1e36, by an estimate of about 12 bits and Newton's method,
/// which is faster than a root and a division. The relative error is 5e-7 in single precision and
/// 1e-13 in double.
template <class V>
[[gnu::always_inline]] inline V inverse_root(const V& x) {
  using Real = typename V::value_type;
  V r = estimated_inverse_root(x);
  const V half = Real(0.5) * x;
  r = r * (Real(1.5) - half * r * r);
  if constexpr (is_double<V>) r = r * (Real(1.5) - half * r * r);
  return r;
}

/// Binary exponent of a normal number x > 0, and x divided by this power of two. The quotient
/// `mantissa` is from sqrt(1/2) to sqrt(2).
template <class V>
struct Split {
  V exponent, mantissa;
};
template <class V>
[[gnu::always_inline]] inline Split<V> split(const V& x) {
  using Real = typename V::value_type;
  using Bits = xsimd::as_unsigned_integer_t<V>;
  using Bit = typename Bits::value_type;
  constexpr int digits = is_double<V> ? 52 : 23;
  constexpr Bit fraction = (Bit{1} << digits) - 1;
  // 2^digits; its last digit has the value 1.
  constexpr Bit one = is_double<V> ? static_cast<Bit>(0x3ff0000000000000) : 0x3f800000;
  constexpr Bit unit = is_double<V> ? static_cast<Bit>(0x4330000000000000) : 0x4b000000;
  constexpr Real bias = static_cast<Real>(fraction) + Real(1) + Real(is_double<V> ? 1023 : 127);
  const Bits bits = xsimd::bitwise_cast<Bits>(x);
  const V m = xsimd::bitwise_cast<V>((bits & Bits(fraction)) | Bits(one));
  const V e = xsimd::bitwise_cast<V>((bits >> digits) | Bits(unit)) - V(bias);
  const auto upper = m > V(Real(1.4142135623730951));
  return {.exponent = xsimd::select(upper, e + Real(1), e),
          .mantissa = xsimd::select(upper, m * Real(0.5), m)};
}

/// Returns 2 atanh(s) for |s| <= 0.172. The relative error is 1e-15 in double precision and 1e-7 in
/// single precision.
template <class V>
[[gnu::always_inline]] inline V twice_area_tangent(const V& s) {
  const V q = s * s;
  if constexpr (is_double<V>) {
    const V q2 = q * q, q4 = q2 * q2;
    const V low = (1.0 + q * (1.0 / 3)) + q2 * (1.0 / 5 + q * (1.0 / 7));
    const V high = (1.0 / 9 + q * (1.0 / 11)) + q2 * (1.0 / 13 + q * (1.0 / 15));
    return (s + s) * (low + q4 * (high + q4 * (1.0 / 17 + q * (1.0 / 19))));
  } else {
    return (s + s) * (1.0f + q * (1.0f / 3 + q * (1.0f / 5 + q * (1.0f / 7 + q * (1.0f / 9)))));
  }
}

inline constexpr double ln_2 = 0.693147180559945309;

/// Returns asinh(z) = ln(z + length) for z >= 0, with `length` = sqrt(1 + z²). For small z, the
/// code uses the equal expression 2 atanh(z/(1 + length)), which keeps the digits of z.
template <class V>
[[gnu::always_inline]] inline V area_sine(const V& z, const V& length) {
  using Real = typename V::value_type;
  const V sum = z + length;
  const Split<V> at = split(sum);
  const auto small = sum < V(Real(1.4142135623730951));
  const V above = xsimd::select(small, z, at.mantissa - Real(1));
  const V below = xsimd::select(small, length + Real(1), at.mantissa + Real(1));
  return at.exponent * Real(ln_2) + twice_area_tangent(above / below);
}

/// Returns ln(1 + t) for t >= 0.
template <class V>
[[gnu::always_inline]] inline V log_one_plus(const V& t) {
  const V sum = t + 1.0;
  const Split<V> at = split(sum);
  const auto small = sum < V(1.4142135623730951);
  const V above = xsimd::select(small, t, at.mantissa - 1.0);
  const V below = xsimd::select(small, t + 2.0, at.mantissa + 1.0);
  return at.exponent * ln_2 + twice_area_tangent(above / below);
}

/// Returns e^x for x from -700 to 700, with a relative error of 1e-15.
template <class V>
[[gnu::always_inline]] inline V exponential(const V& x) {
  using Bits = xsimd::as_unsigned_integer_t<V>;
  constexpr double round = 6755399441055744.0;  // 1.5 2^52; its last digit has the value 1
  const V shifted = x * 1.44269504088896341 + round;
  const V n = shifted - round;
  const V r = (x - n * 0x1.62e42fefa3800p-1) - n * 0x1.ef35793c76730p-45;
  V series = 1.0 / 479001600.0 + r * (1.0 / 6227020800.0);
  series = 1.0 / 3628800.0 + r * (1.0 / 39916800.0 + r * series);
  series = 1.0 / 40320.0 + r * (1.0 / 362880.0 + r * series);
  series = 1.0 / 720.0 + r * (1.0 / 5040.0 + r * series);
  series = 1.0 / 24.0 + r * (1.0 / 120.0 + r * series);
  series = 0.5 + r * (1.0 / 6.0 + r * series);
  series = 1.0 + r * (1.0 + r * series);
  const Bits power = (xsimd::bitwise_cast<Bits>(shifted) + Bits(1023)) << 52;
  return series * xsimd::bitwise_cast<V>(power);
}

/// Returns ln(x) for a normal number x > 0, with an absolute error of 1e-15.
template <class V>
[[gnu::always_inline]] inline V logarithm(const V& x) {
  const Split<V> at = split(x);
  return at.exponent * ln_2 + twice_area_tangent((at.mantissa - 1.0) / (at.mantissa + 1.0));
}

}  // namespace raceway::friction::contact
