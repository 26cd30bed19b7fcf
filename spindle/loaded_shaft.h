#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "bearing/displaced_bearing.h"
#include "bearing/roller_equilibrium.h"
#include "spindle/beam.h"

namespace raceway::spindle {

/// Load on the shaft at one place, in addition to the axial load in ArrangementCondition.
struct ShaftLoad {
  double position = 0.0;  ///< distance behind the nose face [m]
  double axial = 0.0;     ///< positive towards the tool [N]
  /// Loads in the planes of y and z: forces [N], and moments [N m] that are positive in the
  /// direction of θ = dv/ds.
  double radial = 0.0, radial_z = 0.0, moment = 0.0, moment_z = 0.0;
  [[nodiscard]] bool pushes_across() const {
    return radial != 0.0 || radial_z != 0.0 || moment != 0.0 || moment_z != 0.0;
  }
};

/// A cylindrical roller bearing that supports the shaft in addition to its sets, free to move
/// axially.
struct RollerSupport {
  const bearing::RollerBearing* bearing = nullptr;
  double position = unset;  ///< distance behind the nose face [m]
};

/// All bearings that support a shaft. The struct stores pointers to the bearings.
struct ShaftBearings {
  /// Null if the shaft has no sets. The shaft then has no axial support and is assumed not to move
  /// axially.
  const bearing::Arrangement* sets = nullptr;
  std::vector<double> places = {};  ///< centres of the bearings of the sets, front set first [m]
  std::vector<RollerSupport> rollers = {};
};

/// Shaft bent on its bearings. If the solver did not converge, only `report` is valid.
struct LoadedShaft {
  double position = unset;           ///< axial position as in ArrangementEquilibrium [m]
  double rear_displacement = unset;  ///< axial displacement of the rear set [m]
  double front_force = unset, rear_force = unset;  ///< axial forces, summed over each side [N]
  Eigen::VectorXd y, z;                            ///< (v, θ) of all nodes in both planes
  /// Loads on the inner ring of each bearing, and the equilibrium of the balls with displacement
  /// and tangent stiffness. Loads and equilibrium are in the frame of the bearing: +x is the
  /// direction in which the inner ring is pressed.
  std::vector<bearing::Vector5> loads;
  std::vector<bearing::BearingEquilibrium> bearings;
  /// State of the roller bearings, in a frame with x to the rear. `load` is the load from the
  /// shaft.
  std::vector<bearing::RollerEquilibrium> rollers;
  bearing::SolveReport report;
};

class ShaftBalance5;

/// Elastic shaft on all its bearings, under loads at any places. The object solves the problem of
/// solve_loaded_shaft() for one condition after another. Each solution starts from the previous
/// one. Several threads must not use one object simultaneously.
class ShaftOnBearings {
 public:
  /// Bearings and loads must be at nodes of the beam. The beam is not needed after construction.
  /// Throws std::invalid_argument if a node is missing, or if the number of places differs from the
  /// number of bearings.
  ShaftOnBearings(const Beam& beam, ShaftBearings held, std::span<const double> load_places);
  ShaftOnBearings(ShaftOnBearings&&) noexcept;
  ~ShaftOnBearings();

  /// `clearances` are the radial clearances of the roller bearings [m]. Loads act at the places of
  /// the constructor, in the same order. `unbent` is the equilibrium of the sets under axial loads
  /// only, if it is known.
  [[nodiscard]] LoadedShaft solve(const bearing::ArrangementCondition& condition,
                                  std::span<const double> clearances,
                                  std::span<const ShaftLoad> loads,
                                  const bearing::EquilibriumOptions& options = {},
                                  const bearing::ArrangementEquilibrium* unbent = nullptr);

 private:
  std::unique_ptr<ShaftBalance5> balance_;
  Eigen::VectorXd last_;  ///< empty before the first equilibrium
};

/// Finds the equilibrium of the elastic shaft and all bearings of its sets, each in five degrees of
/// freedom, under loads at any places. Newton's method solves for the axial positions of shaft and
/// rear set and for (v, θ) at the bearings in two planes. The beam is condensed onto these nodes,
/// and balls and rollers are in equilibrium at every evaluation. The method starts from the
/// equilibrium under the axial load only. If a start fails, the radial load is increased from zero
/// in steps. Between the sets, the shaft has the axial stiffness of the arrangement.
///
/// Domain:   `places` contains the centres of the bearings on the shaft, front set first. Each
///           centre must be a node of the beam. Throws std::invalid_argument if the number of
///           places differs from the number of bearings.
/// Accuracy: 1e-9 of the largest load; second-order effects of the axial force are neglected.
[[nodiscard]] LoadedShaft solve_loaded_shaft(const Beam& beam,
                                             const bearing::Arrangement& arrangement,
                                             std::span<const double> places,
                                             const bearing::ArrangementCondition& condition,
                                             const ShaftLoad& load,
                                             const bearing::EquilibriumOptions& options = {});

/// Returns true if the inner ring of bearing `i` is pressed to the rear, as in the front set of an
/// O arrangement and in the rear set of an X arrangement.
[[nodiscard]] bool presses_rearwards(const bearing::Arrangement& arrangement, std::size_t i);

/// Returns the tangent stiffness of the bearings as springs of the beam. The coupling of force and
/// tilt changes its sign with the frame: +K(y, θz) if a bearing presses to the rear, otherwise
/// -K(y, θz). The two off-diagonal terms differ by 1 to 2 % at speed; their mean is used.
[[nodiscard]] std::vector<Spring> bearing_springs(
    const bearing::Arrangement& arrangement, std::span<const double> places,
    std::span<const bearing::BearingEquilibrium> bearings);

/// Returns the tangent stiffness of a roller bearing as a spring of the beam. The coupling between
/// the planes of y and z, which arises only for loads outside both planes, is neglected.
[[nodiscard]] Spring roller_spring(double position, const bearing::RollerEquilibrium& rollers);

}  // namespace raceway::spindle
