#include "bearing/ring_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

namespace raceway::bearing {
namespace {

/// A load goes with the 3/2 power of an approach, which is the difference of two lengths: under a
/// load that presses balls by little more than the last digit of these, no more digits are to be
/// had.
double rounding_of(const BallConstantsOf<double>& c, double load) {
  constexpr double digits = 4.0 * std::numeric_limits<double>::epsilon();
  const double root = std::cbrt(load / std::max(c.inner_stiffness, c.outer_stiffness));
  return 1.5 * digits * (c.inner_radius + c.outer_radius) / (root * root);
}

}  // namespace

RingPoint<double> unloaded_point(const Bearing& bearing, const EquilibriumOptions& options) {
  const BearingGeometry& g = bearing.geometry();
  RingPoint<double> ring{};
  const BallConstants constants =
      ball_constants(bearing, 0.0, options.race_control, options.gyroscopic_moment);
  ring.ball = constants;
  ring.springs = spring_pair(constants);
  const double distance = g.groove_centre_distance();
  ring.free = {distance * std::sin(g.contact_angle),
               distance * std::cos(g.contact_angle) - 0.5 * g.radial_clearance};
  ring.lever = g.inner_groove_centre_radius();
  ring.moment_arm_ratio = g.inner_conformity * g.ball_diameter / ring.lever;
  return ring;
}

void set_operating_point(RingPoint<double>& ring, const Bearing& bearing, const OperatingPoint& p,
                         const EquilibriumOptions& options) {
  const std::size_t given = options.rotations.size();
  if (given > 1 && given != bearing.azimuth().size())
    throw std::invalid_argument(
        "rotations: give one rotation for each ball, or one rotation for all balls");
  ring.ball.full_centrifugal = full_centrifugal(bearing, p.speed);
  const bool tilts = options.tilt == Tilt::free;
  const double loads[] = {p.axial_load, p.radial_load, p.radial_load_z,
                          tilts ? p.moment_y / ring.lever : 0.0,
                          tilts ? p.moment_z / ring.lever : 0.0};
  ring.load_scale = 0.0;
  for (int i = 0; i < 5; ++i) {
    ring.load[i] = loads[i];
    ring.load_scale = std::max(ring.load_scale, std::abs(loads[i]));
  }
  ring.ball_scale = ring.load_scale / bearing.geometry().ball_count;
  ring.rounding = rounding_of(ring.ball, ring.ball_scale);
}

BallCircle ball_circle(const Bearing& bearing, const OperatingPoint& p,
                       const EquilibriumOptions& options) {
  const std::size_t given = options.rotations.size();
  if (given > 1 && given != bearing.azimuth().size())
    throw std::invalid_argument(
        "rotations: give one rotation for each ball, or one rotation for all balls");
  const Symmetry symmetry = p.radial_load_z != 0.0 || p.moment_y != 0.0 ? Symmetry::none
                            : p.radial_load != 0.0 || p.moment_z != 0.0 ? Symmetry::mirror
                                                                        : Symmetry::thrust;
  return {.azimuth = bearing.azimuth().data(),
          .cosine = bearing.cos_azimuth().data(),
          .sine = bearing.sin_azimuth().data(),
          .count = bearing.geometry().ball_count,
          .symmetry = symmetry,
          .rotations = options.rotations};
}

BallModel ball_model(const RingPoint<double>& ring, const EquilibriumOptions& options) {
  if (ring.ball.full_centrifugal == 0.0) return BallModel::at_rest;
  if (!options.rotations.empty()) return BallModel::given_rotation;
  return options.race_control == RaceControl::outer ? BallModel::outer_control
                                                    : BallModel::inner_control;
}

template <typename T>
void fill_equilibrium(const T& lever, const BallCircle& circle, const T* ring,
                      const RingReport<T>& report, const BallReport<T>* balls, std::size_t i,
                      BearingEquilibrium& result) {
  const double arm = lane(lever, i);
  for (int r = 0; r < 5; ++r) {
    const double row = r < 3 ? 1.0 : arm;
    result.displacement[r] = lane(ring[r], i) / row;
    for (int c = 0; c < 5; ++c)
      result.stiffness(r, c) = lane(report.stiffness[r][c], i) * row * (c < 3 ? 1.0 : arm);
  }
  result.report.residual = lane(report.residual, i);
  result.report.recovered_load_error = lane(report.recovered_load_error, i);
  const std::span<BallEquilibrium> kept = result.balls.reset(circle.count, circle.symmetry);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    BallReport<double> ball;
    copy_lanes(ball, 0, balls[k], i);
    kept[k] = ball_equilibrium(ball, circle.azimuth[k]);
  }
  result.rotations.clear();
  for (std::size_t k = 0; k < kept.size() && !circle.rotations.empty(); ++k)
    result.rotations.push_back(*circle.rotation(static_cast<int>(k)));
}

template void fill_equilibrium(const double&, const BallCircle&, const double*,
                               const RingReport<double>&, const BallReport<double>*, std::size_t,
                               BearingEquilibrium&);
template void fill_equilibrium(const Eight&, const BallCircle&, const Eight*,
                               const RingReport<Eight>&, const BallReport<Eight>*, std::size_t,
                               BearingEquilibrium&);

}  // namespace raceway::bearing
