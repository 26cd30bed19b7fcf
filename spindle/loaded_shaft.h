#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "bearing/displaced_bearing.h"
#include "spindle/beam.h"

namespace raceway::spindle {

/// What pushes on the shaft at one place, beside the axial load of the condition.
struct ShaftLoad {
  double position = 0.0;  ///< behind the nose face [m]
  double axial = 0.0;     ///< positive towards the tool [N]
  /// In the plane of y and in that of z: forces [N], moments positive as θ = dv/ds [N m].
  double radial = 0.0, radial_z = 0.0, moment = 0.0, moment_z = 0.0;
};

/// The shaft bent on its bearings. Only `report` is set unless the solve converged.
struct LoadedShaft {
  double position = unset;           ///< x of the shaft, as in ArrangementEquilibrium [m]
  double rear_displacement = unset;  ///< δ_r [m]
  double front_force = unset, rear_force = unset;  ///< axial, sums over the sides [N]
  Eigen::VectorXd y, z;                            ///< (v, θ) of all nodes in both planes
  /// Each in its own frame, +x where its inner ring is pressed: loads on the ring, and balls with
  /// displacement and tangent stiffness.
  std::vector<bearing::Vector5> loads;
  std::vector<bearing::BearingEquilibrium> bearings;
  bearing::SolveReport report;
};

/// Finds the balance of the elastic shaft and all bearings of its sets, each in five degrees of
/// freedom, under a load anywhere on the shaft: Newton's method on the axial positions of shaft and
/// rear set and on (v, θ) of the bearings' places in two planes, the beam condensed onto these,
/// the balls in balance at every look. Starts from the balance of the axial load
/// alone; where a start fails, the radial load is followed from zero. Between the sets the shaft is
/// as stiff axially as the arrangement says.
///
/// Domain:   `places` of the bearings' centres on the shaft, front set first, are nodes of the
/// beam. Accuracy: 1e-9 of the largest load; second-order effects of the axial force are left out.
/// Throws std::invalid_argument for another number of places than bearings.
[[nodiscard]] LoadedShaft solve_loaded_shaft(const Beam& beam,
                                             const bearing::Arrangement& arrangement,
                                             std::span<const double> places,
                                             const bearing::ArrangementCondition& condition,
                                             const ShaftLoad& load,
                                             const bearing::EquilibriumOptions& options = {});

/// True where a bearing's inner ring is pressed towards the rear: the front set of an O, the
/// rear set of an X.
[[nodiscard]] bool presses_rearwards(const bearing::Arrangement& arrangement, std::size_t i);

/// Tangent stiffness of the bearings as springs of the beam. The coupling of force and tilt turns
/// with the frame: +K(y, θz) where a bearing presses rearwards, else -K(y, θz). Both
/// off-diagonals, 1 to 2 % apart at speed, are taken as their mean.
[[nodiscard]] std::vector<Spring> bearing_springs(
    const bearing::Arrangement& arrangement, std::span<const double> places,
    std::span<const bearing::BearingEquilibrium> bearings);

}  // namespace raceway::spindle
