#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "record/units.h"

namespace raceway::friction::contact {

/// Points and weights for integrals over an ellipse under Hertz pressure. The points lie in the
/// half x > 0. The half axes are b along x and a along y, and p0 is the peak pressure.
///
///   x = b r cos θ,  y = a r sin θ,  r² = 1 - s²,  p = p0 s,  dx dy = a b s ds dθ
///
/// The points are `Radial` Gauss points in s from 0 to 1, combined with `Angles` midpoints in θ
/// from -π/2 to π/2. No point lies at the centre, where θ is undefined, or at the rim, where the
/// pressure p falls to zero with infinite slope over r. The sum over θ is exact for x^i y^j if i +
/// j is even and at most 2 Angles - 2. The sum over s is exact for p r^(2 n) if n is at most Radial
/// - 2.
template <std::size_t Radial, std::size_t Angles>
struct EllipsePoints {
  std::array<double, Radial> s{};       ///< s = p/p0, pressure divided by peak pressure [1]
  std::array<double, Radial> radius{};  ///< r, relative distance from the centre [1]
  std::array<double, Radial>
      weight{};  ///< weight of each point, s ds dθ [1]; Angles times the sum of `weight` is π/2
  std::array<double, Angles> cosine{}, sine{};

  EllipsePoints() {
    for (std::size_t i = 0; i < Radial; ++i) {
      const auto [node, gauss] = legendre(i);
      s[i] = 0.5 * (1.0 + node);
      radius[i] = std::sqrt(1.0 - s[i] * s[i]);
      weight[i] = 0.5 * gauss * s[i] * pi / static_cast<double>(Angles);
    }
    for (std::size_t j = 0; j < Angles; ++j) {
      const double angle = pi * ((static_cast<double>(j) + 0.5) / Angles - 0.5);
      cosine[j] = std::cos(angle);
      sine[j] = std::sin(angle);
    }
  }

 private:
  struct NodeWeight {
    double node, weight;
  };
  /// Gauss-Legendre points on [-1, 1]: the zeros of P_n by Newton's method.
  static NodeWeight legendre(std::size_t i) {
    constexpr auto n = static_cast<double>(Radial);
    double x = std::cos(pi * (static_cast<double>(i) + 0.75) / (n + 0.5)), slope = 1.0;
    for (int step = 0; step < 20; ++step) {
      double p = 1.0, before = 0.0;
      for (std::size_t k = 1; k <= Radial; ++k) {
        const auto m = static_cast<double>(k);
        const double next = ((2.0 * m - 1.0) * x * p - (m - 1.0) * before) / m;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1.0);
      const double change = p / slope;
      x -= change;
      if (std::abs(change) < 1e-15) break;
    }
    return {x, 2.0 / ((1.0 - x * x) * slope * slope)};
  }
};

template <std::size_t Radial, std::size_t Angles>
inline const EllipsePoints<Radial, Angles> ellipse_points{};

}  // namespace raceway::friction::contact
