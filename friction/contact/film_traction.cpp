#include "friction/contact/film_traction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

#include "friction/contact/side_by_side.h"

namespace raceway::friction::contact {
namespace {

bool has_avx2() {
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}

/// Points go side by side in lanes of sixteen: the angles of a ring where the ball spins, the rings
/// of an angle where it does not and the part y < 0 is the mirror image of y > 0.
template <std::size_t Radial, std::size_t Angles, bool spins>
struct Lanes {
  static constexpr std::size_t width = spins ? Angles : Radial;
  static constexpr std::size_t rows = spins ? Radial : Angles / 2;
  static constexpr double copies = spins ? 2.0 : 4.0;
  static constexpr std::size_t ring(std::size_t row, std::size_t lane) {
    return spins ? row : lane;
  }
  static constexpr std::size_t angle(std::size_t row, std::size_t lane) {
    return spins ? lane : Angles / 2 + row;
  }
};

/// Where the points of the unit circle are.
template <std::size_t Radial, std::size_t Angles, bool spins, std::floating_point Real>
struct LanePoints {
  using L = Lanes<Radial, Angles, spins>;
  using Row = std::array<Real, L::width>;
  std::array<Row, L::rows> x{}, y{};
  std::array<Real, Radial> weight{}, s{};

  LanePoints() {
    const EllipsePoints<Radial, Angles> points;
    for (std::size_t i = 0; i < Radial; ++i) {
      weight[i] = static_cast<Real>(points.weight[i]);
      s[i] = static_cast<Real>(points.s[i]);
    }
    for (std::size_t i = 0; i < L::rows; ++i)
      for (std::size_t j = 0; j < L::width; ++j) {
        const std::size_t ring = L::ring(i, j), angle = L::angle(i, j);
        x[i][j] = static_cast<Real>(points.radius[ring] * points.cosine[angle]);
        y[i][j] = static_cast<Real>(points.radius[ring] * points.sine[angle]);
      }
  }
};
template <std::size_t Radial, std::size_t Angles, bool spins, std::floating_point Real>
const LanePoints<Radial, Angles, spins, Real> lane_points{};

/// The slip field and what the shear law makes of the pressure of each ring, in units of `speed`,
/// Eyring's stress and a.
template <std::size_t Radial, std::floating_point Real>
struct Rings {
  Real differential, spin, width, film_share, small2;
  std::array<Real, Radial> steepness, limit, boundary;
};

template <std::size_t Radial, std::size_t Angles, bool spins>
class SideBySide {
 public:
  SideBySide(const SlidingEllipse& ellipse, const FilmShear& shear) : ellipse_(ellipse) {
    const double a = ellipse.semi_major_axis;
    const double differential = ellipse.differential * a * a, spin = spins ? ellipse.spin * a : 0.0;
    const double fastest = std::abs(differential) + std::abs(spin);
    speed_ = fastest > 0.0 ? fastest : 1.0;
    stress_ = shear.eyring_stress;
    const bool any_film = shear.asperity_share < 1.0 && shear.film > 0.0;
    const double small = shear.small_speed / speed_;
    rings_.differential = differential / speed_;
    rings_.spin = spin / speed_;
    rings_.width = ellipse.semi_minor_axis / a;
    rings_.film_share = any_film ? 1.0 - shear.asperity_share : 0.0;
    rings_.small2 = small * small;
    if (has_avx2())
      wide_rings(shear);
    else
      any_rings(shear);
    search_.differential = static_cast<float>(rings_.differential);
    search_.spin = static_cast<float>(rings_.spin);
    search_.width = static_cast<float>(rings_.width);
    search_.film_share = static_cast<float>(rings_.film_share);
    search_.small2 = static_cast<float>(rings_.small2);
    // A share below rounding is none: at speed most contacts have no asperities, at rest no film.
    film_ = rings_.film_share > 0.0;
    searchable_ = rings_.steepness[0] < 1e18;  // whose square is a number in single precision
    asperities_ = rings_.boundary[0] > 1e-16 * rings_.limit[0];
  }

  [[nodiscard]] Traction rolling() const {
    Traction t;
    t.converged = true;
    TractionSums last;
    const auto balance = [&](double v) {
      last = sums<double>(v);
      t.slip.along = v * speed_;
      return GrowingValue{last.along, last.along_slope, last.force};
    };
    const double range = rings_.differential;
    if (range == 0.0) {
      balance(0.0);
    } else {
      const double low = std::fmin(-range, 0.0), high = std::fmax(-range, 0.0);
      double v = -0.2 * range;
      if (searchable_ && found_by_float(low, high, v))
        balance(v);
      else
        t.converged = find_zero(balance, low, high, v, 1e-6);
    }
    t.power = last.power;
    t.spin_moment = last.spin_moment;
    t.mean_friction = last.force / ellipse_.load;
    t.mean_slip = last.pressure_slip / ellipse_.load;
    return t;
  }

 private:
  using L = Lanes<Radial, Angles, spins>;
  template <std::floating_point Real>
  using Row = std::array<Real, L::width>;

  /// v_x0 [speed_] to what single precision knows of it. True where the bracket is as narrow as
  /// that is, and the forces need not vanish there: a step of dry friction.
  [[nodiscard]] bool found_by_float(double low, double high, double& v) const {
    const double narrow = 1e-6 * (high - low);
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 60; ++step) {
      const TractionSums f = sums<float>(v);
      (f.along > 0.0 ? high : low) = v;
      const double newton = v - f.along / f.along_slope, middle = 0.5 * (low + high);
      if (!(high - low > narrow && middle > low && middle < high)) return true;
      const bool inside = newton > low && newton < high;
      const bool good = inside && std::abs(f.along) < 0.5 * before;
      before = std::abs(f.along);
      v = good ? newton : middle;
      if (inside && before <= 3e-4 * f.force) {
        v = newton;
        break;
      }
    }
    return false;
  }

  template <std::floating_point Real>
  [[nodiscard]] TractionSums sums(double along) const {
    if (!asperities_) return pass<Real, true, false>(along);
    if (!film_) return pass<Real, false, true>(along);
    return pass<Real, true, true>(along);
  }

  // The same on both: no instruction of AVX2 rounds otherwise, multiply-add is not among them.
  template <std::floating_point Real, bool film, bool asperities>
  [[nodiscard]] TractionSums pass(double centre) const {
    return has_avx2() ? wide_pass<Real, film, asperities>(centre)
                      : any_pass<Real, film, asperities>(centre);
  }
  template <std::floating_point Real, bool film, bool asperities>
  [[nodiscard]] TractionSums any_pass(double centre) const {
    return pass_of<Real, film, asperities>(centre);
  }
  template <std::floating_point Real, bool film, bool asperities>
  [[nodiscard, gnu::target("avx2")]] TractionSums wide_pass(double centre) const {
    return pass_of<Real, film, asperities>(centre);
  }
  void any_rings(const FilmShear& shear) { make_rings(shear); }
  [[gnu::target("avx2")]] void wide_rings(const FilmShear& shear) { make_rings(shear); }

  /// FilmShear::at_pressure() of all rings.
  [[gnu::always_inline]] void make_rings(const FilmShear& shear) {
    const auto& grid = lane_points<Radial, Angles, spins, double>;
    const double log = shear.viscosity.logarithm(), exponent = shear.viscosity.exponent();
    const double peak = ellipse_.peak_pressure();
    const double per_reference = peak / Roelands::reference_pressure;
    const double stress = peak / stress_;
    const bool any_film = rings_.film_share > 0.0;
    const double newton =
        any_film ? shear.viscosity.at_no_pressure() * speed_ / (shear.film * stress_) : 0.0;
    const double glass = FilmShear::glass * speed_;
    for (std::size_t i = 0; i < Radial; ++i) {
      const double power = exponential(exponent * log_one_plus(per_reference * grid.s[i]));
      const double thicker = log * (power - 1.0);
      const double steep = newton * exponential(thicker > 690.0 ? 690.0 : thicker);
      rings_.steepness[i] = steep > glass ? glass : steep;
      rings_.limit[i] = rings_.film_share * shear.limiting_traction * stress * grid.s[i];
      rings_.boundary[i] = shear.asperity_share * shear.boundary_friction * stress * grid.s[i];
    }
    for (std::size_t i = 0; i < Radial; ++i) {
      search_.steepness[i] = static_cast<float>(rings_.steepness[i]);
      search_.limit[i] = static_cast<float>(rings_.limit[i]);
      search_.boundary[i] = static_cast<float>(rings_.boundary[i]);
    }
  }

  template <std::floating_point Real>
  [[nodiscard]] const Rings<Radial, Real>& rings() const {
    if constexpr (std::is_same_v<Real, double>)
      return rings_;
    else
      return search_;
  }

  template <std::floating_point Real, bool film, bool asperities>
  [[nodiscard, gnu::always_inline]] TractionSums pass_of(double at) const {
    constexpr bool all = std::is_same_v<Real, double>;
    // Its square is still a number; for 0/0 where nothing slides.
    constexpr Real tiny = all ? Real(1e-150) : Real(1e-18), one = 1;
    const auto& grid = lane_points<Radial, Angles, spins, Real>;
    const Rings<Radial, Real>& r = rings<Real>();
    const auto centre = static_cast<Real>(at);
    const Real spin = r.spin, differential = r.differential, width = r.width;
    const Real share = r.film_share, small2 = r.small2 + tiny * tiny;
    Row<Real> along{}, slope{}, force{}, power{}, moment{}, slip{};
    for (std::size_t i = 0; i < L::rows; ++i) {
      for (std::size_t j = 0; j < L::width; ++j) {
        const std::size_t k = L::ring(i, j);
        const Real y = grid.y[i][j], x = width * grid.x[i][j];
        const Real vx = centre + (differential * y - spin) * y;
        const Real vy = spin * x;
        const Real v2 = spins ? vx * vx + vy * vy : vx * vx;
        const Real v = spins ? std::sqrt(v2) : std::abs(vx), per_v = one / (v + tiny);
        Real secant = 0, tangent = 0;
        if constexpr (asperities) {
          const Real per_root = one / std::sqrt(v2 + small2);
          secant = r.boundary[k] * per_root;
          tangent = secant * small2 * (per_root * per_root);
        }
        if constexpr (film) {
          const Real z = r.steepness[k] * v, limit = r.limit[k];
          const Real length = std::sqrt(one + z * z);
          const Real stress = share * area_sine(z, length);
          const Real slipping = (stress > limit ? limit : stress) * per_v;
          const Real newton = share * r.steepness[k];
          const Real thinned = newton / length;
          secant += z > Real(1e-12) ? slipping : newton;
          tangent += stress > limit ? Real(0) : thinned;
        }
        const Real across = vx * per_v, weight = grid.weight[k];
        along[j] += weight * secant * vx;
        force[j] += weight * secant * v;
        slope[j] += weight * (secant + (tangent - secant) * (across * across));
        if constexpr (all) {
          power[j] += weight * secant * v2;
          if constexpr (spins) moment[j] += weight * secant * (x * vy - y * vx);
          slip[j] += weight * grid.s[k] * v;
        }
      }
    }
    const double a = ellipse_.semi_major_axis;
    const double area = L::copies * a * ellipse_.semi_minor_axis;
    TractionSums total;
    total.along = area * stress_ * sum(along);
    total.along_slope = area * stress_ * sum(slope);  // over v_x0 in units of speed_
    total.force = area * stress_ * sum(force);
    if constexpr (all) {
      total.power = area * stress_ * speed_ * sum(power);
      total.spin_moment = area * stress_ * a * sum(moment);
      total.pressure_slip = area * ellipse_.peak_pressure() * speed_ * sum(slip);
    }
    return total;
  }

  template <class Values>
  [[gnu::always_inline]] static double sum(const Values& values) {
    double total = 0.0;
    for (const auto x : values) total += x;
    return total;
  }

  SlidingEllipse ellipse_;
  double speed_, stress_;
  bool film_, asperities_, searchable_;
  Rings<Radial, double> rings_;
  Rings<Radial, float> search_;
};

}  // namespace

Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear) {
  // Under race control one race spins by what rounding leaves: below a billionth of the other slip.
  const double rolling = std::abs(ellipse.differential) * ellipse.semi_major_axis;
  if (std::abs(ellipse.spin) <= 1e-9 * rolling)
    return SideBySide<16, 24, false>(ellipse, shear).rolling();
  return SideBySide<12, 16, true>(ellipse, shear).rolling();
}

}  // namespace raceway::friction::contact
