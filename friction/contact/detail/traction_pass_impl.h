#pragma once

#include <xsimd/xsimd.hpp>

#include "friction/contact/detail/traction_pass.h"
#include "friction/contact/detail/vector_math.h"

// One source file for each instruction set includes this header. The linker must not merge code
// compiled for different sets, so each function is templated on V or always inlined.
namespace raceway::friction::contact {

template <class V>
void stresses_in(const CirclePoints<double>& points, const RingPressures& p,
                 RingStresses<double>& rings, RingStresses<float>& search) {
  for (std::size_t i = 0; i < points.rings; i += V::size) {
    const V s = V::load_aligned(points.s + i);
    const V power = exponential(p.exponent * log_one_plus(p.pressure * s));
    const V thicker = p.logarithm * (power - 1.0);
    // With select() instead of min(), a NaN stays NaN.
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

/// Shear stress at the slip speed v and its derivative, for the friction mechanisms of the contact.
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
      per_length = estimated_inverse_root(square);
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
  const V tiny2(Real(1e-36));  // keeps 1/v finite at points without slip
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
