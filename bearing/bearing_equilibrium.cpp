#include "bearing/bearing_equilibrium.h"

#include <algorithm>
#include <cmath>

#include "bearing/ball_report.h"
#include "bearing/equilibrium_search.h"

namespace raceway::bearing {
namespace {

/// Of the loads summed again from the reported balls, relative; rounding leaves a thousandth of it.
constexpr double largest_load_error = 1e-8;

/// Sums the loads again from the reported angles and forces: an independent check of the frame
/// and of everything between the unknowns and the report.
double recovered_load_error(const RingSystem& system, const BearingEquilibrium& e,
                            const OperatingPoint& p) {
  Vector5 sum = Vector5::Zero();
  double angle = 0.0, s = 0.0, c = 1.0;
  for (std::size_t k = 0; k < e.balls.size(); ++k) {
    const BallEquilibrium& b = e.balls[k];
    if (!(b.inner_load > 0.0)) continue;
    if (b.inner_contact_angle != angle) {
      angle = b.inner_contact_angle;
      s = std::sin(angle);
      c = std::cos(angle);
    }
    const double axial = b.inner_load * s + b.inner_friction * c;
    const double radial = b.inner_load * c - b.inner_friction * s;
    const double moment = axial * system.lever() - system.geometry().inner_conformity *
                                                       system.geometry().ball_diameter *
                                                       b.inner_friction;
    const double cp = system.bearing().cos_azimuth()[k], sp = system.bearing().sin_azimuth()[k];
    sum += Vector5{axial, radial * cp, radial * sp, moment * sp, -moment * cp};
  }
  Vector5 error{sum[0] - p.axial_load, sum[1] - p.radial_load, sum[2] - p.radial_load_z,
                (sum[3] - p.moment_y) / system.lever(), (sum[4] - p.moment_z) / system.lever()};
  if (system.options().tilt == Tilt::locked) error.tail<2>().setZero();
  return error.cwiseAbs().maxCoeff() / system.load_scale();
}

void fill(const RingSystem& system, const RingState& state, const OperatingPoint& point,
          BearingEquilibrium& result) {
  result.displacement = state.ring;
  result.displacement.tail<2>() /= system.lever();
  result.stiffness = system.solution().stiffness;
  result.stiffness.rightCols<2>() *= system.lever();
  result.stiffness.bottomRows<2>() *= system.lever();
  result.report.residual = system.solution().residual;
  const auto z = static_cast<std::size_t>(system.geometry().ball_count);
  result.balls.resize(z);
  for (std::size_t k = 0; k < z; ++k) {
    const std::size_t source = system.symmetry() == Symmetry::thrust   ? 0
                               : system.symmetry() == Symmetry::mirror ? std::min(k, z - k)
                                                                       : k;
    BallEquilibrium& ball = result.balls[k];
    if (source == k) {
      ball = ball_report(system.solution().balls[k].forces, system.groove_centre(state.ring, k),
                         state.balls[k], system.at_rest(), system.geometry().ball_diameter);
    } else {
      ball = result.balls[source];
    }
    ball.azimuth = 2.0 * pi * static_cast<double>(k) / static_cast<double>(z);
  }
  result.report.recovered_load_error = recovered_load_error(system, result, point);
}

BearingEquilibrium solve(const Bearing& bearing, const OperatingPoint& point,
                         const EquilibriumOptions& options, const BearingEquilibrium* neighbour) {
  validate(point);
  thread_local RingWorkspace workspace;
  RingSystem system(bearing, point, options, workspace);
  BearingEquilibrium result;
  RingState& state = workspace.state;
  result.report.status = find_equilibrium(system, point, neighbour, state);
  result.report.iterations = system.iterations();
  if (!result.report.converged()) return result;
  fill(system, state, point, result);
  // The self-check of every solve: what does not carry the load is no result.
  if (result.report.recovered_load_error <= largest_load_error) return result;
  BearingEquilibrium refused;
  refused.report = result.report;
  refused.report.status = SolveStatus::no_equilibrium;
  return refused;
}

}  // namespace

std::string_view name(SolveStatus status) {
  switch (status) {
    case SolveStatus::not_run:
      return "not_run";
    case SolveStatus::converged:
      return "converged";
    case SolveStatus::no_equilibrium:
      return "no_equilibrium";
    case SolveStatus::iteration_limit:
      return "iteration_limit";
    case SolveStatus::singular:
      return "singular";
    case SolveStatus::not_finite:
      return "not_finite";
  }
  return "not_run";
}

int BearingEquilibrium::lost_balls() const {
  return static_cast<int>(std::count_if(
      balls.begin(), balls.end(), [](const BallEquilibrium& b) { return !(b.inner_load > 0.0); }));
}

BallSpeeds BearingEquilibrium::speeds(std::size_t k, const Bearing& bearing, double speed,
                                      RaceControl race_control) const {
  const BallEquilibrium& b = balls.at(k);
  const bool lost = std::isnan(b.inner_contact_angle);
  return ball_speeds(lost ? RaceControl::outer : race_control,
                     lost ? b.outer_contact_angle : b.inner_contact_angle, b.outer_contact_angle,
                     bearing.geometry().diameter_ratio(), speed);
}

BearingEquilibrium solve_bearing_equilibrium(const Bearing& bearing, const OperatingPoint& point,
                                             const EquilibriumOptions& options) {
  return solve(bearing, point, options, nullptr);
}

BearingEquilibrium solve_bearing_equilibrium(const Bearing& bearing, const OperatingPoint& point,
                                             const EquilibriumOptions& options,
                                             const BearingEquilibrium& neighbour) {
  return solve(bearing, point, options, &neighbour);
}

}  // namespace raceway::bearing
