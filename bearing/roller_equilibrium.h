#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "bearing/contact_pressure.h"
#include "bearing/operating_point.h"
#include "bearing/roller_bearing.h"
#include "bearing/solve.h"

namespace raceway::bearing {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;

struct RollerOptions {
  /// With `locked`, the ring has the tilts tilt_y and tilt_z. With `free`, the ring tilts until the
  /// rollers balance the given moments.
  Tilt tilt = Tilt::locked;
  double tilt_y = 0.0, tilt_z = 0.0;  ///< imposed ring tilt, right-handed about y and z [rad]
  /// Radial clearance s in operation [m]. If NaN, the clearance of the geometry is used.
  double clearance = unset;
  /// Largest accepted imbalance of forces [1], relative to the largest of these forces: applied
  /// load, centrifugal force of a roller, and roller loads.
  double tolerance = 1e-11;
  int max_iterations = 500;  ///< limit of Newton steps
};

/// One roller in equilibrium.
struct LoadedRoller {
  double azimuth = unset;     ///< ψ from +y towards +z [rad]
  double inner_load = unset;  ///< Qi, load at the inner raceway [N]
  double outer_load = unset;  ///< Qo, load at the outer raceway [N]
  /// Outward displacement u of the roller [m]; 0 if the roller just touches the outer raceway.
  double shift = unset;
  double tilt = unset;  ///< f, tilt of the roller's axis in its radial plane [rad]
  /// Loads of the slices into which the roller is divided along its length, in the order of
  /// RollerBearing::positions() [N].
  std::array<double, lamina_count> inner_laminae{}, outer_laminae{};
};

/// Equilibrium of the inner ring and the rollers under a load. If the solver did not converge, only
/// `report` is set.
struct RollerEquilibrium {
  /// Displacement y, z [m], θ_y, θ_z [rad] of the inner ring at the middle plane of the rollers,
  /// measured from the centred position.
  Vector4 displacement = Vector4::Constant(unset);
  /// Loads F_y, F_z [N], M_y, M_z [N m] that act on the inner ring. If the tilt is locked, the
  /// moments are reactions.
  Vector4 load = Vector4::Constant(unset);
  /// Symmetric tangent stiffness ∂load/∂displacement with the rollers in equilibrium [SI].
  Matrix4 stiffness = Matrix4::Constant(unset);
  std::vector<LoadedRoller> rollers;
  double clearance = unset;          ///< radial clearance s of this equilibrium [m]
  double centrifugal_force = unset;  ///< force on one roller [N]
  /// ∂(Σ Qi)/∂s at constant forces on the ring and constant tilt [N/m]. The value is never
  /// positive, because a larger clearance reduces the sum of the roller loads. Σ Qo has the same
  /// derivative.
  double sum_by_clearance = unset;
  /// True if there is no load, and no roller touches the inner ring. This state is a valid
  /// equilibrium. The ring is free within its clearance, so stiffness and radial displacement are
  /// reported as zero.
  bool loose = false;
  SolveReport report;

  /// Status in JSON results: "loose", or the name of the solver status, such as "converged".
  [[nodiscard]] std::string_view status() const { return loose ? "loose" : name(report.status); }
  /// Σ Qi and Σ Qo over all rollers [N].
  [[nodiscard]] double inner_sum() const;
  [[nodiscard]] double outer_sum() const;
  /// Number of rollers that touch the inner ring [1].
  [[nodiscard]] int loaded_rollers() const;
  /// Largest load of a slice at this race, over all rollers [N].
  [[nodiscard]] double largest_lamina(Race race) const;
};

/// Finds the displacement of the inner ring at which the rollers carry the applied load.
///
///   approach of the raceways at azimuth ψ and distance x from the middle of the roller:
///     e = y cos ψ + z sin ψ + x (θ_z cos ψ - θ_y sin ψ) - s/2
///
///   slices    qi = c1 (e - u - x f - P(x))^(10/9),   qo = c1 (u + x f - P(x))^(10/9)
///
///   rollers   Σ qo - Σ qi = Fc,   Σ x qo = Σ x qi
///
///   ring      Σ qi cos ψ = F_y,   Σ qi sin ψ = F_z,   Σ x qi cos ψ = M_z,   -Σ x qi sin ψ = M_y
///
///   tangent stiffness of the ring   K = Σ B'(Ki - Ki (Ki + Ko)^-1 Ki) B
///
/// y, z, θ_y and θ_z are the displacements of the ring, s is the radial clearance, and P is
/// roller_relief(). qi and qo are the loads of a slice at the inner and the outer raceway. c1 is
/// explained in LineContact. u and f are shift and tilt of a roller (LoadedRoller). Fc is the
/// centrifugal force of a roller.
///
/// The equilibrium is the minimum of a convex energy of ring and rollers. Newton's method with a
/// line search solves for all unknowns. Ki and Ko are the contact stiffness matrices of a roller at
/// the inner and the outer raceway. B maps the ring displacement to the approach and tilt of the
/// raceways at the roller. If only one slice of a roller has contact, Ki + Ko is singular, and the
/// pseudo-inverse replaces the inverse.
///
/// Source:   at rest, the formulas of [ISO16281], as two other programs implement them. The series
///           connection of the contacts and the terms with Fc are derived.
/// Domain:   speed >= 0 and axial_load = 0; the function throws std::invalid_argument for another
///           axial load. If there is no load and no roller touches the inner ring, the status is
///           `loose`. The solver does not move the ring in a direction without stiffness, for
///           example perpendicular to the load of a single loaded roller.
/// Accuracy: the relative imbalance is at most `tolerance`, or the imbalance is a rounding
///           error. The model assumes rigid rings and quasi-static motion. The model ignores roller
///           skew, flange friction, cage slip and film. The solver treats an approach δ below 1e-15
///           m as no contact. The stiffness dq/dδ is proportional to the ninth root of δ, so even a
///           rounding error of δ would give a noticeable stiffness.
[[nodiscard]] RollerEquilibrium solve_roller_bearing(const RollerBearing& bearing,
                                                     const OperatingPoint& point,
                                                     const RollerOptions& options = {});

class RollerBalance;

/// Finds the equilibrium of the rollers for a given displacement of the inner ring. The
/// displacement has the coordinates x, y, z [m], θ_y and θ_z [rad]; the axial coordinate x has no
/// effect. Use this class for many displacements and clearances. Each solve starts from the
/// previous solution. The bearing must exist as long as the object.
class DisplacedRollerBearing {
 public:
  /// If `clearance` is NaN, the clearance of the geometry is used.
  DisplacedRollerBearing(const RollerBearing& bearing, double speed, double clearance = unset);
  DisplacedRollerBearing(DisplacedRollerBearing&&) noexcept;
  DisplacedRollerBearing& operator=(DisplacedRollerBearing&&) noexcept;
  ~DisplacedRollerBearing();

  void set_clearance(double clearance);
  /// Finds the equilibrium of the rollers at the given displacement of the inner ring. Returns
  /// false if no equilibrium is found; force and stiffness are then invalid.
  [[nodiscard]] bool hold(const Vector5& displacement);
  /// External forces on the ring that balance the roller forces: F_x = 0, F_y, F_z [N], M_y, M_z
  /// [N m].
  [[nodiscard]] const Vector5& force() const { return force_; }
  /// Tangent stiffness ∂force/∂displacement with the rollers in equilibrium [SI].
  [[nodiscard]] const Matrix5& stiffness() const { return stiffness_; }
  /// Returns all results at the displacement of the last call of hold().
  [[nodiscard]] RollerEquilibrium equilibrium() const;

 private:
  double clearance_;
  std::unique_ptr<RollerBalance> balance_;
  SolveReport report_;
  Vector5 force_ = Vector5::Constant(unset);
  Matrix5 stiffness_ = Matrix5::Constant(unset);
};

/// Finds the equilibrium of the rollers at a given displacement of the inner ring. The member
/// `load` of the result is the external load at this displacement. If `clearance` is NaN, the
/// clearance of the geometry is used.
[[nodiscard]] RollerEquilibrium displaced_roller_bearing(const RollerBearing& bearing,
                                                         const Vector4& displacement, double speed,
                                                         double clearance = unset);

/// Returns the largest Hertz pressures over all slices [Pa]: 0 for a race without contact, and NaN
/// if the equilibrium did not converge.
[[nodiscard]] ContactPressure largest_pressure(const RollerBearing& bearing,
                                               const RollerEquilibrium& equilibrium);

/// Hertz pressure that defines the static rating of roller bearings [Pa]. Source: [ISO76].
inline constexpr double static_limit_pressure_of_lines = 4000e6;

/// Approximate ring tilt above which the roller ends are overloaded [rad]. The value has no
/// published source.
inline constexpr double usual_tilt_limit = 1.2e-3;

}  // namespace raceway::bearing
