#include "model/tilted_equilibrium.h"

#include <Eigen/LU>
#include <cmath>

namespace raceway::model {
namespace {

constexpr double tolerance = 1e-10;  // [rad]
constexpr int most_steps = 30;

/// What is missing to the tilt.
Eigen::Vector2d missing(const bearing::BearingEquilibrium& e, double tilt) {
  return {-e.displacement[3], tilt - e.displacement[4]};
}

/// Moments that move the ring so far while the forces stay: the tilt stiffness with the
/// displacements eliminated.
Eigen::Vector2d moments_for(const bearing::BearingEquilibrium& e, const Eigen::Vector2d& tilt) {
  const Eigen::Matrix2d stiffness =
      e.stiffness.bottomRightCorner<2, 2>() -
      e.stiffness.bottomLeftCorner<2, 3>() * e.stiffness.topLeftCorner<3, 3>().partialPivLu().solve(
                                                 e.stiffness.topRightCorner<3, 2>());
  return stiffness * tilt;
}

}  // namespace

bearing::BearingEquilibrium solve_tilted(const Model& model, const bearing::Bearing& bearing,
                                         bearing::OperatingPoint point, double tilt,
                                         const friction::Lubricant& oil,
                                         const bearing::BearingEquilibrium* neighbour,
                                         HoldingMoments& moments) {
  bearing::EquilibriumOptions options = model.solver;
  options.tilt = bearing::Tilt::free;
  const bool held = neighbour && std::isfinite(moments.y) && std::isfinite(moments.z);
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  if (held)
    moment =
        Eigen::Vector2d(moments.y, moments.z) + moments_for(*neighbour, missing(*neighbour, tilt));
  const auto solve = [&](const bearing::BearingEquilibrium* from) {
    point.moment_y = moment[0];
    point.moment_z = moment[1];
    return solve_balls(model, bearing, point, options, oil, from);
  };
  bearing::BearingEquilibrium e = solve(neighbour);
  for (int i = 0; i < most_steps && e.report.converged(); ++i) {
    const Eigen::Vector2d rest = missing(e, tilt);
    if (rest.lpNorm<Eigen::Infinity>() < tolerance) {
      moments = {moment[0], moment[1]};
      return e;
    }
    moment += moments_for(e, rest);
    e = solve(&e);
  }
  moments = {};
  // A step too far from where it began: from no moment, as without a neighbour that is held.
  if (held) return solve_tilted(model, bearing, point, tilt, oil, nullptr, moments);
  if (e.report.converged()) e.report.status = bearing::SolveStatus::iteration_limit;
  return e;
}

}  // namespace raceway::model
