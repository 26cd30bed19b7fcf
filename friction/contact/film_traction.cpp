#include "friction/contact/film_traction.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace raceway::friction::contact {
namespace {

/// asinh(x) for x >= 0 to 1e-15 relative, without a branch or a call, so that a compiler can make
/// several at once: log(1 + t), t = x + x²/(1 + sqrt(1 + x²)), as 2 atanh(s) of the mantissa.
[[gnu::always_inline]] inline double area_sine(double x, double length) {
  const double t = x + x * x / (1.0 + length);
  const auto bits = std::bit_cast<std::uint64_t>(1.0 + t);
  constexpr std::uint64_t mantissa = 0x000fffffffffffff, one = 0x3ff0000000000000;
  constexpr std::uint64_t whole = 0x4330000000000000;  // 2^52, whose last digits count units
  const double m = std::bit_cast<double>((bits & mantissa) | one);
  const double exponent =
      std::bit_cast<double>((bits >> 52) | whole) - (4503599627370496.0 + 1023.0);
  const bool upper = m > std::numbers::sqrt2;
  const double reduced = upper ? 0.5 * m : m;
  const bool small = t < std::numbers::sqrt2 - 1.0;  // keeps the digits of a small t
  const double scale = small ? 0.0 : (upper ? exponent + 1.0 : exponent);
  const double s = (small ? t : reduced - 1.0) / (small ? t + 2.0 : reduced + 1.0);
  const double q = s * s;
  // 1 + q/3 + ... + q^9/19, written out: a loop here would keep the points from going side by side.
  double series = 1.0 / 17.0 + q / 19.0;
  series = 1.0 / 13.0 + q * (1.0 / 15.0 + q * series);
  series = 1.0 / 9.0 + q * (1.0 / 11.0 + q * series);
  series = 1.0 / 5.0 + q * (1.0 / 7.0 + q * series);
  series = 1.0 + q * (1.0 / 3.0 + q * series);
  return scale * std::numbers::ln2 + 2.0 * s * series;
}

bool has_avx2() {
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}

/// The points of one contact, ring by ring, with what the shear law makes of their pressure.
template <std::size_t Radial, std::size_t Angles, bool spins>
class SideBySide {
 public:
  /// Without spin the part y < 0 is the mirror image of y > 0.
  static constexpr std::size_t count = spins ? Angles : Angles / 2;
  static constexpr double copies = spins ? 2.0 : 4.0;

  SideBySide(const SlidingEllipse& ellipse, const FilmShear& shear) : ellipse_(ellipse) {
    for (std::size_t i = 0; i < Radial; ++i)
      points_[i] = shear.at_pressure(ellipse.peak_pressure() * grid().s[i]);
  }

  [[nodiscard]] const SlidingEllipse& ellipse() const { return ellipse_; }

  /// All sums where the centre slides along at that speed.
  [[nodiscard]] TractionSums sums(double along) const {
    // A share below rounding is none: at speed most contacts have no asperities, at rest no film.
    if (points_.back().boundary <= 1e-16 * points_.back().limit) return pass<true, false>(along);
    if (!(points_.back().film_share > 0.0)) return pass<false, true>(along);
    return pass<true, true>(along);
  }

 private:
  using Row = std::array<double, count>;
  static const EllipsePoints<Radial, Angles>& grid() { return ellipse_points<Radial, Angles>; }

  // The same on both: no instruction of AVX2 rounds otherwise, multiply-add is not among them.
  template <bool film, bool asperities>
  [[nodiscard]] TractionSums pass(double centre) const {
    return has_avx2() ? wide_pass<film, asperities>(centre) : any_pass<film, asperities>(centre);
  }
  template <bool film, bool asperities>
  [[nodiscard]] TractionSums any_pass(double centre) const {
    return pass_of<film, asperities>(centre);
  }
  template <bool film, bool asperities>
  [[nodiscard, gnu::target("avx2")]] TractionSums wide_pass(double centre) const {
    return pass_of<film, asperities>(centre);
  }

  template <bool film, bool asperities>
  [[nodiscard, gnu::always_inline]] TractionSums pass_of(double centre) const {
    constexpr double tiny = 1e-150;  // its square is still a number; for 0/0 where nothing slides
    const double a = ellipse_.semi_major_axis, b = ellipse_.semi_minor_axis;
    const double spin = spins ? ellipse_.spin : 0.0, differential = ellipse_.differential;
    Row along{}, slope{}, force{}, power{}, moment{}, slip{};
    for (std::size_t i = 0; i < Radial; ++i) {
      const FilmShear::Point& p = points_[i];
      const double eyring = p.film_share * p.eyring_stress, limit = p.film_share * p.limit;
      const double steepness = p.steepness, newton = eyring * steepness;
      const double small2 = p.small_speed2 + tiny * tiny, boundary = p.boundary;
      const double weight = grid().weight[i], s = grid().s[i];
      const double height = a * grid().radius[i], width = b * grid().radius[i];
      for (std::size_t j = 0; j < count; ++j) {
        const double y = height * grid().sine[Angles - count + j];
        const double x = width * grid().cosine[Angles - count + j];
        const double vx = centre + (differential * y - spin) * y;
        const double vy = spin * x;
        const double v2 = vx * vx + vy * vy;
        const double v = std::sqrt(v2), per_v = 1.0 / (v + tiny);
        double secant = 0.0, tangent = 0.0;
        if constexpr (asperities) {
          const double per_root = 1.0 / std::sqrt(v2 + small2);
          secant = boundary * per_root;
          tangent = secant * small2 * (per_root * per_root);
        }
        if constexpr (film) {
          const double z = steepness * v;
          const double length = std::sqrt(1.0 + z * z);
          const double stress = eyring * area_sine(z, length);
          const double slipping = (stress > limit ? limit : stress) * per_v;
          const double thinned = newton / length;
          secant += z > 1e-12 ? slipping : newton;
          tangent += stress > limit ? 0.0 : thinned;
        }
        const double across = vx * per_v;
        along[j] += weight * secant * vx;
        force[j] += weight * secant * v;
        slope[j] += weight * (secant + (tangent - secant) * (across * across));
        power[j] += weight * secant * v2;
        moment[j] += weight * secant * (x * vy - y * vx);
        slip[j] += weight * s * v;
      }
    }
    const double area = copies * a * b;
    TractionSums total;
    total.along = area * sum(along);
    total.along_slope = area * sum(slope);
    total.force = area * sum(force);
    total.power = area * sum(power);
    total.spin_moment = spins ? area * sum(moment) : 0.0;
    total.pressure_slip = area * ellipse_.peak_pressure() * sum(slip);
    return total;
  }

  static double sum(const Row& row) {
    double total = 0.0;
    for (const double x : row) total += x;
    return total;
  }

  SlidingEllipse ellipse_;
  std::array<FilmShear::Point, Radial> points_{};
};

template <class Points>
Traction traction_of_points(const Points& points) {
  const SlidingEllipse& e = points.ellipse();
  const double range = e.differential * e.semi_major_axis * e.semi_major_axis;
  TractionSums last;
  Traction t;
  t.converged = true;
  const auto balance = [&](double v) {
    last = points.sums(v);
    t.slip.along = v;
    return GrowingValue{last.along, last.along_slope, last.force};
  };
  if (range == 0.0) {
    balance(0.0);
  } else {
    double v = -0.2 * range;
    t.converged = find_zero(balance, std::fmin(-range, 0.0), std::fmax(-range, 0.0), v, 1e-6);
  }
  t.power = last.power;
  t.spin_moment = last.spin_moment;
  t.mean_friction = last.force / e.load;
  t.mean_slip = last.pressure_slip / e.load;
  return t;
}

}  // namespace

Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear) {
  // Under race control one race spins by what rounding leaves: below a billionth of the other slip.
  const double rolling = std::abs(ellipse.differential) * ellipse.semi_major_axis;
  if (std::abs(ellipse.spin) <= 1e-9 * rolling)
    return traction_of_points(SideBySide<16, 24, false>(ellipse, shear));
  return traction_of_points(SideBySide<12, 16, true>(ellipse, shear));
}

}  // namespace raceway::friction::contact
