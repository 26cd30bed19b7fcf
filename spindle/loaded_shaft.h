#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "bearing/displaced_bearing.h"
#include "bearing/roller_equilibrium.h"
#include "spindle/beam.h"

namespace raceway::spindle {

/// Load on the shaft at one place, in addition to the axial load of the condition.
struct ShaftLoad {
  double position = 0.0;  ///< behind the nose face [m]
  double axial = 0.0;     ///< positive towards the tool [N]
  /// In the planes of y and z: forces [N], moments positive as θ = dv/ds [N m].
  double radial = 0.0, radial_z = 0.0, moment = 0.0, moment_z = 0.0;
  [[nodiscard]] bool pushes_across() const {
    return radial != 0.0 || radial_z != 0.0 || moment != 0.0 || moment_z != 0.0;
  }
};

/// A cylindrical roller bearing that holds the shaft in addition to its sets, free along the axis.
struct RollerSupport {
  const bearing::RollerBearing* bearing = nullptr;
  double position = unset;  ///< behind the nose face [m]
};

/// All bearings that hold a shaft. Keeps pointers to them.
struct ShaftBearings {
  /// Null where there are none: then nothing holds the shaft along its axis, and nothing moves it.
  const bearing::Arrangement* sets = nullptr;
  std::vector<double> places = {};  ///< of the bearings of the sets, front set first [m]
  std::vector<RollerSupport> rollers = {};
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
  /// State of the roller bearings, in a frame with x rearwards: `load` is what the shaft presses
  /// with.
  std::vector<bearing::RollerEquilibrium> rollers;
  bearing::SolveReport report;
};

class ShaftBalance5;

/// The elastic shaft on all bearings that hold it, under loads anywhere on it: the balance of
/// solve_loaded_shaft(), asked for again and again with other conditions, each solved from the one
/// before it. Not for several threads at once.
class ShaftOnBearings {
 public:
  /// Bearings and loads stand at nodes of the beam, which may go once this is made. Throws
  /// std::invalid_argument where there is no such node, or another number of places than bearings.
  ShaftOnBearings(const Beam& beam, ShaftBearings held, std::span<const double> load_places);
  ShaftOnBearings(ShaftOnBearings&&) noexcept;
  ~ShaftOnBearings();

  /// `clearances` of the roller bearings [m]; loads at the places of the constructor, in their
  /// order. `unbent`: the sets under the axial loads alone, where that is known.
  [[nodiscard]] LoadedShaft solve(const bearing::ArrangementCondition& condition,
                                  std::span<const double> clearances,
                                  std::span<const ShaftLoad> loads,
                                  const bearing::EquilibriumOptions& options = {},
                                  const bearing::ArrangementEquilibrium* unbent = nullptr);

 private:
  std::unique_ptr<ShaftBalance5> balance_;
  Eigen::VectorXd last_;  ///< empty before the first balance
};

/// Finds the balance of the elastic shaft and all bearings of its sets, each in five degrees of
/// freedom, under a load anywhere on the shaft: Newton's method on the axial positions of shaft and
/// rear set and on (v, θ) of the bearings' places in two planes, the beam condensed onto these,
/// balls and rollers in balance at every look. Starts from the balance of the axial load
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

/// Tangent stiffness of a roller bearing. What couples the planes of y and z, which a load in
/// neither of them does, is left out.
[[nodiscard]] Spring roller_spring(double position, const bearing::RollerEquilibrium& rollers);

}  // namespace raceway::spindle
