#include "bearing/ring_balance.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace raceway::bearing {

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
}

BallCircle ball_circle(const Bearing& bearing, const OperatingPoint& p) {
  const Symmetry symmetry = p.radial_load_z != 0.0 || p.moment_y != 0.0 ? Symmetry::none
                            : p.radial_load != 0.0 || p.moment_z != 0.0 ? Symmetry::mirror
                                                                        : Symmetry::thrust;
  return {.azimuth = bearing.azimuth().data(),
          .cosine = bearing.cos_azimuth().data(),
          .sine = bearing.sin_azimuth().data(),
          .count = bearing.geometry().ball_count,
          .symmetry = symmetry};
}

BallModel ball_model(const RingPoint<double>& ring, RaceControl race_control) {
  if (ring.ball.full_centrifugal == 0.0) return BallModel::at_rest;
  return race_control == RaceControl::outer ? BallModel::outer_control : BallModel::inner_control;
}

void fill_equilibrium(double lever, const BallCircle& circle, const double* ring,
                      const RingReport<double>& report, const BallReport<double>* balls,
                      BearingEquilibrium& result) {
  for (int i = 0; i < 5; ++i) {
    const double row = i < 3 ? 1.0 : lever;
    result.displacement[i] = ring[i] / row;
    for (int j = 0; j < 5; ++j)
      result.stiffness(i, j) = report.stiffness[i][j] * row * (j < 3 ? 1.0 : lever);
  }
  result.report.residual = report.residual;
  result.report.recovered_load_error = report.recovered_load_error;
  const std::span<BallEquilibrium> kept = result.balls.reset(circle.count, circle.symmetry);
  for (std::size_t k = 0; k < kept.size(); ++k)
    kept[k] = ball_equilibrium(balls[k], circle.azimuth[k]);
}

}  // namespace raceway::bearing
