#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "bearing/solve_many.h"
#include "bench/robustness_domain.h"

/// Random bearings over the whole range that a model file and the command line allow. The solver
/// must return a correct status even for unlikely bearings.
namespace raceway::robustness {

struct WildCase {
  bearing::Bearing bearing;
  bearing::OperatingPoint point;
  bearing::EquilibriumOptions options;
};

/// Returns case number `index` of a seed; equal on every machine. A bearing has 3 to 200 balls of
/// 0.1 to 300 mm and conformities f of 0.5005 to 0.7. The speed is 1e-9 to 1e6 rpm, and the axial
/// load is 1e-9 to 1e8 N. Radial loads and the moment over the pitch diameter are zero or up to ten
/// times the axial load. These numbers (f - 0.5 for f) are uniform in their logarithm. The contact
/// angle is uniform from 0.1 to 65 deg. A tenth of the cases is at standstill, and a tenth has no
/// axial load. The balls are steel or ceramic, the race control is outer or inner, and the tilt is
/// locked or free.
inline WildCase make_wild_case(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t state = seed * 0x9e3779b97f4a7c15ULL + index * 0xd1342543de82ef95ULL;
  const auto uniform = [&state](double lower, double upper) {
    return uniform_number(state, lower, upper);
  };
  const auto spread = [&](double lower, double upper) {
    return std::clamp(std::exp(uniform(std::log(lower), std::log(upper))), lower, upper);
  };
  const auto one_in = [&](double n) { return uniform(0.0, n) < 1.0; };
  bearing::BearingGeometry g;
  g.ball_count = static_cast<int>(spread(3.0, 200.999));
  // As large as still leaves room for all balls on a pitch circle within its range.
  const double room = std::max(1.21, 1.001 / std::sin(pi / g.ball_count));
  g.ball_diameter = spread(std::max(0.1, 1.0 / room), std::min(300.0, 4999.0 / room)) * mm;
  g.pitch_diameter = std::min(g.ball_diameter * room * spread(1.0, 3.0), 5000 * mm);
  g.pitch_diameter = std::max(g.pitch_diameter, 1 * mm);
  g.bore = std::max(0.0, g.pitch_diameter - 1.5 * g.ball_diameter);
  g.contact_angle = uniform(0.1, 65.0) * degree;
  g.inner_conformity = 0.5 + spread(0.0005, 0.2);
  g.outer_conformity = 0.5 + spread(0.0005, 0.2);
  WildCase c{bearing::Bearing(g, one_in(2) ? bearing::silicon_nitride() : bearing::steel(),
                              bearing::steel()),
             {},
             {}};
  const double load = spread(1e-9, 1e8);
  const auto beside = [&] { return std::min(1e8, load * spread(1e-6, 10.0)); };
  c.point.speed = one_in(10) ? 0.0 : spread(1e-9, 1e6) * rpm;
  c.point.axial_load = one_in(10) ? 0.0 : load;
  if (one_in(2)) c.point.radial_load = beside();
  if (one_in(4)) c.point.radial_load_z = beside();
  c.options.tilt = one_in(2) ? bearing::Tilt::locked : bearing::Tilt::free;
  if (c.options.tilt == bearing::Tilt::free && one_in(4))
    c.point.moment_z = std::min(1e8 * N_mm, beside() * g.pitch_diameter);
  c.options.race_control = one_in(2) ? bearing::RaceControl::outer : bearing::RaceControl::inner;
  return c;
}

/// Returns true if all numbers of a converged result are finite, except the inner contact angle of
/// a ball without inner load and the outer contact angle of a ball without outer load.
inline bool finite_if_converged(const bearing::BearingEquilibrium& e) {
  if (!e.report.converged()) return true;
  const auto finite = [](std::initializer_list<double> numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  };
  bool all = e.displacement.allFinite() && e.stiffness.allFinite() &&
             finite({e.report.residual, e.report.recovered_load_error});
  for (const bearing::BallEquilibrium& b : e.balls.distinct())
    all = all &&
          finite({b.inner_load, b.outer_load, b.inner_friction, b.outer_friction,
                  b.centrifugal_force, b.gyroscopic_moment}) &&
          (std::isfinite(b.inner_contact_angle) || !(b.inner_load > 0.0)) &&
          (std::isfinite(b.outer_contact_angle) || !(b.outer_load > 0.0));
  return all;
}

}  // namespace raceway::robustness
