#include "model/tilted_equilibrium.h"

#include <Eigen/LU>

namespace raceway::model {

bearing::BearingEquilibrium solve_tilted(const Model& model, const bearing::Bearing& bearing,
                                         bearing::OperatingPoint point, double tilt,
                                         const friction::Lubricant& oil,
                                         const bearing::BearingEquilibrium* neighbour) {
  constexpr double tolerance = 1e-10;  // [rad]
  constexpr int most_steps = 30;
  bearing::EquilibriumOptions options = model.solver;
  options.tilt = bearing::Tilt::free;
  point.moment_y = point.moment_z = 0.0;
  bearing::BearingEquilibrium e = solve_balls(model, bearing, point, options, oil, neighbour);
  for (int i = 0; i < most_steps && e.report.converged(); ++i) {
    const Eigen::Vector2d missing(-e.displacement[3], tilt - e.displacement[4]);
    if (missing.lpNorm<Eigen::Infinity>() < tolerance) return e;
    // Forces stay: the tilt stiffness with the displacements eliminated.
    const Eigen::Matrix2d stiffness = e.stiffness.bottomRightCorner<2, 2>() -
                                      e.stiffness.bottomLeftCorner<2, 3>() *
                                          e.stiffness.topLeftCorner<3, 3>().partialPivLu().solve(
                                              e.stiffness.topRightCorner<3, 2>());
    const Eigen::Vector2d moment = stiffness * missing;
    point.moment_y += moment[0];
    point.moment_z += moment[1];
    e = solve_balls(model, bearing, point, options, oil, &e);
  }
  if (e.report.converged()) e.report.status = bearing::SolveStatus::iteration_limit;
  return e;
}

}  // namespace raceway::model
