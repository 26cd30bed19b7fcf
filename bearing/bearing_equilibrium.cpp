#include "bearing/bearing_equilibrium.h"

#include <cmath>

#include "bearing/equilibrium_search.h"

namespace raceway::bearing {
namespace {

BearingEquilibrium solve(const Bearing& bearing, const OperatingPoint& point,
                         const EquilibriumOptions& options, const BearingEquilibrium* neighbour) {
  validate(point);
  thread_local RingWorkspace workspace;
  RingSystem system(bearing, point, options, workspace);
  BearingEquilibrium result;
  RingState& state = workspace.state;
  result.report.status = find_equilibrium(system, point, neighbour, state);
  result.report.iterations = system.iterations();
  if (!result.report.converged()) {
    result.report.certain = cannot_balance(system, point);
    return result;
  }
  system.fill(state, result);
  if (result.report.recovered_load_error <= largest_load_error) return result;
  BearingEquilibrium refused;
  refused.report = result.report;
  refused.report.status = std::isnan(result.report.recovered_load_error)
                              ? SolveStatus::not_finite
                              : SolveStatus::no_equilibrium;
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
  double lost = 0.0;
  for (std::size_t i = 0; i < balls.distinct().size(); ++i)
    if (!(balls.distinct()[i].inner_load > 0.0)) lost += balls.weight(i);
  return static_cast<int>(lost);
}

BallSpeeds BearingEquilibrium::speeds(std::size_t k, const Bearing& bearing, double speed,
                                      RaceControl race_control) const {
  const BallEquilibrium b = balls.at(k);
  const bool lost = std::isnan(b.inner_contact_angle);
  if (!lost && !rotations.empty())
    return ball_rotation(rotations[balls.twin(k)], b.inner_contact_angle, b.outer_contact_angle,
                         bearing.geometry().diameter_ratio(), speed)
        .speeds();
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
