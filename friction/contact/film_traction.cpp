#include "friction/contact/film_traction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "bearing/solve_many.h"
#include "friction/contact/detail/traction_pass.h"

namespace raceway::friction::contact {
namespace {

const TractionKernel& traction_kernel() {
  static const TractionKernel kernel = [] {
    switch (bearing::best_instruction_set()) {
      case bearing::InstructionSet::avx512:
        return traction_kernel_avx512();
      case bearing::InstructionSet::avx2:
        return traction_kernel_avx2();
      case bearing::InstructionSet::sse2:
        break;
    }
    return traction_kernel_sse2();
  }();
  return kernel;
}

/// 12 x 16 points of the half ellipse where the ball spins, 16 x 12 of the quarter where not.
struct SlipPoints {
  CirclePoints<double> wide{};
  CirclePoints<float> narrow{};
  double copies;  ///< of these points that make the ellipse

  explicit SlipPoints(bool spins) : copies(spins ? 2.0 : 4.0) {
    if (spins)
      fill(EllipsePoints<12, 16>(), true);
    else
      fill(EllipsePoints<16, 24>(), false);
  }

 private:
  template <std::size_t Radial, std::size_t Angles>
  void fill(const EllipsePoints<Radial, Angles>& points, bool spins) {
    wide.rings = narrow.rings = Radial;
    wide.rows = narrow.rows = spins ? Radial : Angles / 2;
    for (std::size_t i = 0; i < Radial; ++i) {
      wide.weight[i] = points.weight[i];
      wide.s[i] = points.s[i];
      narrow.weight[i] = static_cast<float>(points.weight[i]);
      narrow.s[i] = static_cast<float>(points.s[i]);
    }
    for (std::size_t i = 0; i < wide.rows; ++i)
      for (std::size_t j = 0; j < side_by_side; ++j) {
        const std::size_t ring = spins ? i : j, angle = spins ? j : Angles / 2 + i;
        wide.x[i][j] = points.radius[ring] * points.cosine[angle];
        wide.y[i][j] = points.radius[ring] * points.sine[angle];
        narrow.x[i][j] = static_cast<float>(wide.x[i][j]);
        narrow.y[i][j] = static_cast<float>(wide.y[i][j]);
      }
  }
};
const SlipPoints& slip_points(bool spins) {
  static const SlipPoints spinning(true), straight(false);
  return spins ? spinning : straight;
}

/// One contact, in the units of RingStresses.
class SlidingContact {
 public:
  SlidingContact(const SlidingEllipse& ellipse, const FilmShear& shear, bool spins)
      : ellipse_(ellipse), points_(slip_points(spins)), spins_(spins) {
    const double a = ellipse.semi_major_axis;
    const double differential = ellipse.differential * a * a;
    const double spin = spins ? ellipse.spin * a : 0.0;
    const double fastest = std::abs(differential) + std::abs(spin);
    speed_ = fastest > 0.0 ? fastest : 1.0;
    stress_ = shear.eyring_stress;
    const double film_share =
        shear.asperity_share < 1.0 && shear.film > 0.0 ? 1.0 - shear.asperity_share : 0.0;
    const double small = shear.small_speed / speed_;
    wide_.differential = differential / speed_;
    wide_.spin = spin / speed_;
    wide_.width = ellipse.semi_minor_axis / a;
    wide_.film_share = film_share;
    wide_.small2 = small * small;
    narrow_.differential = static_cast<float>(wide_.differential);
    narrow_.spin = static_cast<float>(wide_.spin);
    narrow_.width = static_cast<float>(wide_.width);
    narrow_.film_share = static_cast<float>(wide_.film_share);
    narrow_.small2 = static_cast<float>(wide_.small2);
    const double peak = ellipse.peak_pressure();
    const Roelands& oil = shear.viscosity;
    const RingPressures pressures{
        .logarithm = oil.logarithm(),
        .exponent = oil.exponent(),
        .pressure = peak / Roelands::reference_pressure,
        .newton = film_share > 0.0 ? oil.at_no_pressure() * speed_ / (shear.film * stress_) : 0.0,
        .glass = FilmShear::glass * speed_,
        .limit = film_share * shear.limiting_traction * peak / stress_,
        .boundary = shear.asperity_share * shear.boundary_friction * peak / stress_};
    kernel_.stresses(points_.wide, pressures, wide_, narrow_);
    // A share below rounding is none: at speed most contacts have no asperities, at rest no film.
    rubbing_ = pressures.boundary <= 1e-16 * pressures.limit ? Rubbing::film
               : film_share > 0.0                            ? Rubbing::both
                                                             : Rubbing::asperities;
    // The first ring has the highest pressure; squares are numbers in single precision.
    searchable_ = wide_.steepness[0] < 1e18;
  }

  [[nodiscard]] Traction rolling(double& centre) const {
    Traction t;
    t.converged = true;
    PassSums last;
    const auto balance = [&](double v) {
      last = kernel_.sum(points_.wide, wide_, rubbing_, spins_, v);
      t.slip.along = v * speed_;
      return GrowingValue{last.along, last.slope, last.force};
    };
    const double range = wide_.differential;
    if (range == 0.0) {
      balance(0.0);
    } else {
      const double low = std::fmin(-range, 0.0), high = std::fmax(-range, 0.0);
      double v = -centre * range;
      if (searchable_ && steps_at(low, high, v))
        balance(v);
      else
        t.converged = find_zero(balance, low, high, v, 1e-6);
      centre = std::clamp(-v / range, 0.001, 0.999);
    }
    const double a = ellipse_.semi_major_axis;
    const double area = points_.copies * a * ellipse_.semi_minor_axis;
    t.power = area * stress_ * speed_ * last.power;
    t.spin_moment = area * stress_ * a * last.moment;
    t.mean_friction = area * stress_ * last.force / ellipse_.load;
    t.mean_slip = area * ellipse_.peak_pressure() * speed_ * last.slip / ellipse_.load;
    return t;
  }

 private:
  /// Brings v_x0 to what single precision knows of it. True where that is a step of dry friction,
  /// in a bracket as narrow as single precision allows: the forces need not vanish there.
  [[nodiscard]] bool steps_at(double low, double high, double& v) const {
    const double narrow = 1e-6 * (high - low);
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 60; ++step) {
      const PassSums f = kernel_.search(points_.narrow, narrow_, rubbing_, spins_, v);
      (f.along > 0.0 ? high : low) = v;
      const double newton = v - f.along / f.slope, middle = 0.5 * (low + high);
      if (!(high - low > narrow && middle > low && middle < high)) return true;
      const bool inside = newton > low && newton < high;
      const double size = std::abs(f.along);
      v = inside && size < 0.5 * before ? newton : middle;
      before = size;
      if (inside && size <= 3e-4 * f.force) {
        v = newton;  // good to the square of that
        return false;
      }
    }
    return false;
  }

  const SlidingEllipse& ellipse_;
  const SlipPoints& points_;
  const TractionKernel& kernel_ = traction_kernel();
  bool spins_, searchable_;
  Rubbing rubbing_;
  double speed_, stress_;
  RingStresses<double> wide_;
  RingStresses<float> narrow_;
};

}  // namespace

Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear, double& centre) {
  const bool spins = spins_beside(ellipse.spin, ellipse.differential, ellipse.semi_major_axis);
  return SlidingContact(ellipse, shear, spins).rolling(centre);
}

Traction film_traction(const SlidingEllipse& ellipse, const FilmShear& shear) {
  double centre = usual_centre;
  return film_traction(ellipse, shear, centre);
}

}  // namespace raceway::friction::contact
