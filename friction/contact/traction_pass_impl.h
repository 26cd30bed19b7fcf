#pragma once

#include <xsimd/xsimd.hpp>

#include "friction/contact/traction_pass.h"

// Included by one source for each instruction set. What is compiled with the flags of that set must
// not be taken by the linker for another: here all functions are named by V, or always inlined.
namespace raceway::friction::contact {

template <class V>
inline constexpr bool is_double = sizeof(typename V::value_type) == 8;

/// 1/sqrt(x), x from 1e-36 to 1e36: an estimate of some 12 bits and Newton's method, which is
/// faster than a root and a division. To 5e-7 in single precision, 1e-13 in double.
template <class V>
[[gnu::always_inline]] inline V inverse_root(const V& x) {
  using Real = typename V::value_type;
  V r = xsimd::rsqrt(x);
  const V half = Real(0.5) * x;
  r = r * (Real(1.5) - half * r * r);
  if constexpr (is_double<V>) r = r * (Real(1.5) - half * r * r);
  return r;
}

/// Exponent of x >= 1, and x over that power of two, from sqrt(1/2) to sqrt(2).
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
  // 2^digits, whose last digits count units.
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

/// 2 atanh(s), |s| <= 0.172, to 1e-15 relative in double, 1e-7 in single precision.
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

/// asinh(z), z >= 0, `length` = sqrt(1 + z²): the logarithm of their sum, or where that is small
/// 2 atanh(z/(1 + length)), which keeps the digits of a small z.
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

/// ln(1 + t), t >= 0.
template <class V>
[[gnu::always_inline]] inline V log_one_plus(const V& t) {
  const V sum = t + 1.0;
  const Split<V> at = split(sum);
  const auto small = sum < V(1.4142135623730951);
  const V above = xsimd::select(small, t, at.mantissa - 1.0);
  const V below = xsimd::select(small, t + 2.0, at.mantissa + 1.0);
  return at.exponent * ln_2 + twice_area_tangent(above / below);
}

/// e^x, x from -700 to 700, to 1e-15 relative.
template <class V>
[[gnu::always_inline]] inline V exponential(const V& x) {
  using Bits = xsimd::as_unsigned_integer_t<V>;
  constexpr double round = 6755399441055744.0;  // 1.5 2^52, whose last digits count units
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

template <class V>
void stresses_in(const CirclePoints<double>& points, const RingPressures& p,
                 RingStresses<double>& rings, RingStresses<float>& search) {
  for (std::size_t i = 0; i < points.rings; i += V::size) {
    const V s = V::load_aligned(points.s + i);
    const V power = exponential(p.exponent * log_one_plus(p.pressure * s));
    const V thicker = p.logarithm * (power - 1.0);
    // The order of min() lets through what is no number.
    const V steep = p.newton * exponential(xsimd::select(thicker > V(690.0), V(690.0), thicker));
    xsimd::select(steep > V(p.glass), V(p.glass), steep).store_aligned(rings.steepness + i);
    (p.limit * s).store_aligned(rings.limit + i);
    (p.boundary * s).store_aligned(rings.boundary + i);
  }
  for (std::size_t i = 0; i < points.rings; ++i) {
    search.steepness[i] = static_cast<float>(rings.steepness[i]);
    search.limit[i] = static_cast<float>(rings.limit[i]);
    search.boundary[i] = static_cast<float>(rings.boundary[i]);
  }
}

/// Stress at a slip v = v2/|v|, and its slope, of the parts that rub.
template <class V>
struct Stress {
  V stress, tangent;
};
template <class V, Rubbing rubbing>
[[gnu::always_inline]] inline Stress<V> stress_of(const V& v, const V& v2, const V& share,
                                                  const V& small2, const V& steepness,
                                                  const V& limit, const V& boundary) {
  using Real = typename V::value_type;
  Stress<V> t{V(Real(0)), V(Real(0))};
  if constexpr (rubbing != Rubbing::asperities) {
    const V z = steepness * v, square = z * z + Real(1);
    V length, per_length;
    if constexpr (is_double<V>) {
      length = xsimd::sqrt(square);  // beyond the range of inverse_root()
      per_length = xsimd::rsqrt(square);
    } else {
      per_length = inverse_root(square);
      length = square * per_length;
    }
    const V sheared = share * area_sine(z, length);
    const auto limited = sheared > limit;
    t.stress = xsimd::select(limited, limit, sheared);
    t.tangent = xsimd::select(limited, V(Real(0)), share * steepness * per_length);
  }
  if constexpr (rubbing != Rubbing::film) {
    const V per_root = inverse_root(v2 + small2);
    const V edge = boundary * per_root;
    t.stress = t.stress + edge * v;
    t.tangent = t.tangent + edge * (small2 * (per_root * per_root));
  }
  return t;
}

template <class V, Rubbing rubbing, bool spins>
PassSums pass_in(const CirclePoints<typename V::value_type>& points,
                 const RingStresses<typename V::value_type>& rings, double at) {
  using Real = typename V::value_type;
  constexpr bool all = is_double<V>;
  const V tiny2(Real(1e-36));  // keeps 1/v a number where nothing slides
  const V centre(static_cast<Real>(at)), spin(rings.spin), differential(rings.differential);
  const V width(rings.width), share(rings.film_share), small2 = V(rings.small2) + tiny2;
  V along(Real(0)), slope(Real(0)), force(Real(0)), power(Real(0)), moment(Real(0)), slip(Real(0));
  for (std::size_t j = 0; j < side_by_side; j += V::size) {
    for (std::size_t i = 0; i < points.rows; ++i) {
      const auto of_ring = [&](const Real* ring) __attribute__((always_inline)) {
        if constexpr (spins)
          return V(ring[i]);
        else
          return V::load_aligned(ring + j);
      };
      const V y = V::load_aligned(points.y[i] + j), weight = of_ring(points.weight);
      const V vx = centre + (differential * y - spin) * y;
      V v, v2 = vx * vx, vy(Real(0)), x(Real(0)), per_v(Real(0));
      if constexpr (spins) {
        x = width * V::load_aligned(points.x[i] + j);
        vy = spin * x;
        v2 = v2 + vy * vy;
        per_v = inverse_root(v2 + tiny2);
        v = v2 * per_v;
      } else {
        v = xsimd::abs(vx);
      }
      const Stress<V> t = stress_of<V, rubbing>(v, v2, share, small2, of_ring(rings.steepness),
                                                of_ring(rings.limit), of_ring(rings.boundary));
      const V pull = weight * t.stress;
      force = force + pull;
      if constexpr (spins) {
        const V direction = vx * per_v, squared = direction * direction;
        along = along + pull * direction;
        slope = slope + (pull * per_v) * (Real(1) - squared) + (weight * t.tangent) * squared;
        if constexpr (all) moment = moment + (pull * per_v) * (x * vy - y * vx);
      } else {
        along = along + xsimd::copysign(pull, vx);
        slope = slope + weight * t.tangent;
      }
      if constexpr (all) {
        power = power + pull * v;
        slip = slip + weight * of_ring(points.s) * v;
      }
    }
  }
  const auto sum = [](const V& x) __attribute__((always_inline)) {
    return static_cast<double>(xsimd::hadd(x));
  };
  PassSums total{.along = sum(along), .slope = sum(slope), .force = sum(force)};
  if constexpr (all) {
    total.power = sum(power);
    total.moment = sum(moment);
    total.slip = sum(slip);
  }
  return total;
}

template <class V>
PassSums pass_of(const CirclePoints<typename V::value_type>& points,
                 const RingStresses<typename V::value_type>& rings, Rubbing rubbing, bool spins,
                 double at) {
  switch (rubbing) {
    case Rubbing::film:
      return spins ? pass_in<V, Rubbing::film, true>(points, rings, at)
                   : pass_in<V, Rubbing::film, false>(points, rings, at);
    case Rubbing::asperities:
      return spins ? pass_in<V, Rubbing::asperities, true>(points, rings, at)
                   : pass_in<V, Rubbing::asperities, false>(points, rings, at);
    case Rubbing::both:
      break;
  }
  return spins ? pass_in<V, Rubbing::both, true>(points, rings, at)
               : pass_in<V, Rubbing::both, false>(points, rings, at);
}

template <class Set>
TractionKernel traction_kernel_in() {
  return {.stresses = stresses_in<xsimd::batch<double, Set>>,
          .search = pass_of<xsimd::batch<float, Set>>,
          .sum = pass_of<xsimd::batch<double, Set>>};
}

}  // namespace raceway::friction::contact
