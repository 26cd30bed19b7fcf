#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "bearing/displaced_bearing.h"
#include "bearing/roller_equilibrium.h"
#include "spindle/beam.h"

namespace raceway::spindle {

/// Load on the shaft at one position, in addition to the axial load in ArrangementCondition.
struct ShaftLoad {
  double position = 0.0;  ///< distance behind the nose face [m]
  double axial = 0.0;     ///< positive towards the tool [N]
  /// Forces [N] and moments [N m] in the planes of y and z. A moment is positive in the direction
  /// of the slope θ = dv/ds, with the deflection v and the distance s behind the nose face.
  double radial = 0.0, radial_z = 0.0, moment = 0.0, moment_z = 0.0;
  [[nodiscard]] bool pushes_across() const {
    return radial != 0.0 || radial_z != 0.0 || moment != 0.0 || moment_z != 0.0;
  }
};

/// Cylindrical roller bearing that supports the shaft in addition to the bearing sets. The shaft
/// can move axially in this bearing.
struct RollerSupport {
  const bearing::RollerBearing* bearing = nullptr;
  double position = unset;  ///< distance behind the nose face [m]
};

/// All bearings that support a shaft. The struct stores pointers, so the bearings must exist as
/// long as the struct.
struct ShaftBearings {
  /// Null if the shaft has no bearing sets. Such a shaft has no axial support; the calculation then
  /// assumes that the shaft does not move axially.
  const bearing::Arrangement* sets = nullptr;
  std::vector<double> places = {};  ///< centres of the bearings in the sets, front set first [m]
  std::vector<RollerSupport> rollers = {};
};

/// Equilibrium of a bent shaft on its bearings. If the solver did not converge, only `report` is
/// valid.
struct LoadedShaft {
  /// Axial displacement of the shaft from its mounted position, positive towards the tool [m].
  /// Without bearing sets, position and axial forces are NaN.
  double position = unset;
  /// Axial compression of the rear set [m]; NaN without a rear set.
  double rear_displacement = unset;
  double front_force = unset, rear_force = unset;  ///< axial forces of the bearing sets [N]
  /// Deflection v and slope θ of all nodes, (v, θ), in the planes of y and z [m, rad].
  Eigen::VectorXd y, z;
  /// Load on the inner ring of each bearing in the sets. `bearings` contains ball equilibrium, ring
  /// displacement and tangent stiffness of each bearing. The axis +x of a bearing is the direction
  /// in which the preload presses the inner ring.
  std::vector<bearing::Vector5> loads;
  std::vector<bearing::BearingEquilibrium> bearings;
  /// Equilibrium of each roller bearing, with the x axis towards the rear. The member `load` of
  /// each entry is the load from the shaft.
  std::vector<bearing::RollerEquilibrium> rollers;
  bearing::SolveReport report;
};

class ShaftBalance5;

/// Elastic shaft on all its bearings, under loads at several positions. Use this class instead of
/// solve_loaded_shaft() for many load cases of one shaft. Each solution starts from the previous
/// solution. Several threads must not use one object simultaneously.
class ShaftOnBearings {
 public:
  /// The positions of bearings and loads [m] must be nodes of the beam. The object does not refer
  /// to `beam` after construction. Throws std::invalid_argument if a node is missing, or if the
  /// number of `held.places` differs from the number of bearings in the sets.
  ShaftOnBearings(const Beam& beam, ShaftBearings held, std::span<const double> load_places);
  ShaftOnBearings(ShaftOnBearings&&) noexcept;
  ~ShaftOnBearings();

  /// Returns the equilibrium under these loads. `clearances` contains the diametral clearance of
  /// each roller bearing [m]. The loads act at the `load_places` of the constructor, in the same
  /// order. `unbent` is the equilibrium of the bearing sets under axial loads only; null if
  /// unknown.
  [[nodiscard]] LoadedShaft solve(const bearing::ArrangementCondition& condition,
                                  std::span<const double> clearances,
                                  std::span<const ShaftLoad> loads,
                                  const bearing::EquilibriumOptions& options = {},
                                  const bearing::ArrangementEquilibrium* unbent = nullptr);

 private:
  std::unique_ptr<ShaftBalance5> balance_;
  Eigen::VectorXd last_;  ///< unknowns of the last equilibrium; empty before the first one
};

/// Finds the equilibrium of an elastic shaft and its bearing sets under a load at one position.
/// Each bearing has five degrees of freedom. Between the bearing sets, the shaft has the axial
/// stiffness given in the arrangement.
///
/// Domain:   `places` contains the centres of the bearings, front set first [m]. Each bearing
///           centre and the position of the load must be nodes of the beam. Throws
///           std::invalid_argument if a node is missing, or if the number of centres differs from
///           the number of bearings.
/// Accuracy: the force error is at most 1e-9 of the preload or of the largest load, whichever is
///           larger. Second-order effects of the axial force are neglected.
[[nodiscard]] LoadedShaft solve_loaded_shaft(const Beam& beam,
                                             const bearing::Arrangement& arrangement,
                                             std::span<const double> places,
                                             const bearing::ArrangementCondition& condition,
                                             const ShaftLoad& load,
                                             const bearing::EquilibriumOptions& options = {});

/// Returns true if the preload presses the inner ring of bearing `i` to the rear. This is true for
/// the front set of an O or tandem arrangement, and for the rear set of an X arrangement.
[[nodiscard]] bool presses_rearwards(const bearing::Arrangement& arrangement, std::size_t i);

/// Returns the tangent stiffness of the bearings as springs for the beam calculation. K(y, θz) is
/// the element of a bearing's stiffness matrix for the force in y and the tilt about z. The
/// coupling of force and tilt is +K(y, θz) if the preload presses the inner ring to the rear,
/// otherwise -K(y, θz). In the plane of z, -K(z, θy) replaces K(y, θz). At speed, K(y, θz) and
/// K(θz, y) differ by 1 to 2 %; the mean of both is used.
[[nodiscard]] std::vector<Spring> bearing_springs(
    const bearing::Arrangement& arrangement, std::span<const double> places,
    std::span<const bearing::BearingEquilibrium> bearings);

/// Returns the tangent stiffness of a roller bearing as a spring for the beam calculation. The
/// coupling between the planes of y and z, which arises only for loads outside both planes, is
/// neglected.
[[nodiscard]] Spring roller_spring(double position, const bearing::RollerEquilibrium& rollers);

}  // namespace raceway::spindle
