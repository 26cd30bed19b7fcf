#include "friction/contact/slip_forces.h"

#include <cmath>
#include <tuple>

#include "friction/contact/area_sine.h"

namespace raceway::friction::contact {
namespace {

template <std::size_t n>
double total_of(const std::array<double, n>& row) {
  double total = 0.0;
  for (const double x : row) total += x;
  return total;
}

/// Of all points of a ring: τ/v, (dτ/dv - τ/v)/v², both times its weight, and v.
template <bool film, bool asperities, class Row>
[[gnu::always_inline]] inline void shear_of_ring(const FilmShear::Point& p, double weight,
                                                 double radius, const SlipMotion& motion,
                                                 double curve, const Row& unit_x, const Row& unit_y,
                                                 Row& secants, Row& turns, Row& speeds) {
  constexpr double tiny = 1e-100;  // its square is still a number; for 0/0 where nothing slides
  const double eyring = p.film_share * p.eyring_stress, limit = p.film_share * p.limit;
  const double steepness = p.steepness, newton = eyring * steepness;
  const double small2 = p.small_speed2 + tiny * tiny, boundary = p.boundary;
  for (std::size_t j = 0; j < std::tuple_size_v<Row>; ++j) {
    const double x = radius * unit_x[j], y = radius * unit_y[j];
    const double vx = motion.along + motion.rolling * (curve * (y * y)) - motion.spin * y;
    const double vy = motion.across + motion.spin * x;
    const double v2 = vx * vx + vy * vy;
    const double v = std::sqrt(v2) + tiny;
    double per_v = 0.0, secant = 0.0, tangent = 0.0;
    if constexpr (asperities) {
      const double per_root = 1.0 / std::sqrt(v2 + small2);
      secant = boundary * per_root;
      tangent = secant * small2 * (per_root * per_root);
    }
    if constexpr (film) {
      const double z = steepness * v;
      const double length = std::sqrt(1.0 + z * z);
      const double reciprocal = 1.0 / (v * length);  // one division for 1/v and 1/length
      per_v = length * reciprocal;
      const double stress = eyring * area_sine(z, length);
      const double slipping = (stress > limit ? limit : stress) * per_v;
      const double thinned = newton * (v * reciprocal);
      secant += z > 1e-12 ? slipping : newton;
      tangent += stress > limit ? 0.0 : thinned;
    } else {
      per_v = 1.0 / v;
    }
    secants[j] = weight * secant;
    turns[j] = weight * (tangent - secant) * per_v * per_v;
    speeds[j] = v;
  }
}

bool slips_wide() {
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}

}  // namespace

SlippingContact::SlippingContact(const SlidingEllipse& ellipse, const FilmShear& shear,
                                 double pressed_radius)
    : ellipse_(ellipse), pressed_radius_(pressed_radius), small_speed_(shear.small_speed) {
  const auto& grid = ellipse_points<radial, angles>;
  for (std::size_t i = 0; i < radial; ++i)
    points_[i] = shear.at_pressure(ellipse.peak_pressure() * grid.s[i]);
}

void SlippingContact::smooth(double times) {
  const double speed = times * small_speed_;
  for (FilmShear::Point& p : points_) p.small_speed2 = speed * speed;
}

SlipForces SlippingContact::forces(const SlipMotion& motion) const {
  // A share below rounding is none: at speed most contacts have no asperities, at rest no film.
  if (points_.back().boundary <= 1e-16 * points_.back().limit) return pass<true, false>(motion);
  if (!(points_.back().film_share > 0.0)) return pass<false, true>(motion);
  return pass<true, true>(motion);
}

// The same on both: no instruction of AVX2 rounds otherwise, multiply-add is not among them.
template <bool film, bool asperities>
SlipForces SlippingContact::pass(const SlipMotion& motion) const {
  return slips_wide() ? wide_pass<film, asperities>(motion) : any_pass<film, asperities>(motion);
}
template <bool film, bool asperities>
SlipForces SlippingContact::any_pass(const SlipMotion& motion) const {
  return pass_of<film, asperities>(motion);
}
template <bool film, bool asperities>
[[gnu::target("avx2")]] SlipForces SlippingContact::wide_pass(const SlipMotion& motion) const {
  return pass_of<film, asperities>(motion);
}

template <bool film, bool asperities>
[[gnu::always_inline]] inline SlipForces SlippingContact::pass_of(const SlipMotion& motion) const {
  using Row = std::array<double, 2 * angles>;  // both sides of a ring
  const auto& grid = ellipse_points<radial, angles>;
  const double a = ellipse_.semi_major_axis, b = ellipse_.semi_minor_axis;
  const double curve = 0.5 / pressed_radius_;
  Row fx{}, fy{}, fh{}, fs{}, power{}, size{}, slip{};
  // k: of dτ/dv by x and y; then with the arms by which rolling (h) and spin (s) move a point.
  Row kxx{}, kxy{}, kyy{}, kxh{}, kyh{}, kxs{}, kys{}, khh{}, khs{}, kss{};
  Row unit_x, unit_y, secant, turn, speed;
  for (std::size_t j = 0; j < angles; ++j) {
    unit_x[j] = b * grid.cosine[j];
    unit_x[angles + j] = -unit_x[j];
    unit_y[j] = unit_y[angles + j] = a * grid.sine[j];
  }
  for (std::size_t i = 0; i < radial; ++i) {
    const FilmShear::Point& p = points_[i];
    const double radius = grid.radius[i], weight = grid.weight[i], s = grid.s[i];
    // Two loops: what a point shears with takes long one after another, what it adds does not.
    shear_of_ring<film, asperities>(p, weight, radius, motion, curve, unit_x, unit_y, secant, turn,
                                    speed);
    for (std::size_t j = 0; j < 2 * angles; ++j) {
      const double x = radius * unit_x[j], y = radius * unit_y[j];
      const double h = curve * (y * y);
      const double vx = motion.along + motion.rolling * h - motion.spin * y;
      const double vy = motion.across + motion.spin * x;
      const double tx = secant[j] * vx, ty = secant[j] * vy;
      fx[j] += tx;
      fy[j] += ty;
      fh[j] += tx * h;
      fs[j] += x * ty - y * tx;
      power[j] += tx * vx + ty * vy;
      size[j] += secant[j] * speed[j];
      slip[j] += weight * s * speed[j];
      const double xx = secant[j] + turn[j] * (vx * vx), xy = turn[j] * (vx * vy);
      const double yy = secant[j] + turn[j] * (vy * vy);
      const double xs = x * xy - y * xx, ys = x * yy - y * xy;
      kxx[j] += xx;
      kxy[j] += xy;
      kyy[j] += yy;
      kxh[j] += xx * h;
      kyh[j] += xy * h;
      kxs[j] += xs;
      kys[j] += ys;
      khh[j] += xx * (h * h);
      khs[j] += xs * h;
      kss[j] += x * ys - y * xs;
    }
  }
  const double area = a * b;
  SlipForces f;
  f.force = {area * total_of(fx), area * total_of(fy), area * total_of(fh), area * total_of(fs)};
  const Row* const upper[4][4] = {{&kxx, &kxy, &kxh, &kxs},
                                  {&kxy, &kyy, &kyh, &kys},
                                  {&kxh, &kyh, &khh, &khs},
                                  {&kxs, &kys, &khs, &kss}};
  for (int k = 0; k < 4; ++k)
    for (int l = k; l < 4; ++l) f.slope[k][l] = f.slope[l][k] = area * total_of(*upper[k][l]);
  f.power = area * total_of(power);
  f.size = area * total_of(size);
  f.pressure_slip = area * ellipse_.peak_pressure() * total_of(slip);
  return f;
}

}  // namespace raceway::friction::contact
