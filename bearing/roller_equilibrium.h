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
  /// With `locked`, tilt_y and tilt_z are imposed. With `free`, the ring tilts until it balances
  /// the given moments.
  Tilt tilt = Tilt::locked;
  double tilt_y = 0.0, tilt_z = 0.0;  ///< imposed ring tilt, right-handed about y and z [rad]
  /// Radial clearance s in operation [m]; if it is NaN, the clearance of the geometry is used.
  double clearance = unset;
  /// Limit of the largest imbalance, relative to the largest of applied load, centrifugal force and
  /// roller loads [1].
  double tolerance = 1e-11;
  int max_iterations = 500;  ///< limit of Newton steps
};

/// One roller in equilibrium.
struct LoadedRoller {
  double azimuth = unset;     ///< ψ from +y towards +z [rad]
  double inner_load = unset;  ///< Qi, load at the inner raceway [N]
  double outer_load = unset;  ///< Qo, load at the outer raceway [N]
  double shift = unset;  ///< u, outward displacement of the roller from the position in which it
                         ///< just touches the outer raceway [m]
  double tilt = unset;   ///< f, tilt of the roller's axis in its radial plane [rad]
  /// Loads of the slices, in the order of RollerBearing::positions() [N].
  std::array<double, lamina_count> inner_laminae{}, outer_laminae{};
};

/// Equilibrium of the inner ring and the rollers under a load. If the solve did not converge, only
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
  /// ∂(Σ Qi)/∂s at constant forces on the ring and constant tilt, never positive [N/m]: additional
  /// clearance reduces the sum of the roller loads. Σ Qo has the same derivative.
  double sum_by_clearance = unset;
  /// True if there is no load and no inner contact. Such a state is a valid equilibrium. Its
  /// stiffness is zero and its radial displacement is reported as zero, because the ring is free
  /// within its clearance.
  bool loose = false;
  SolveReport report;

  /// Status in JSON results: "loose", "converged" and so on.
  [[nodiscard]] std::string_view status() const { return loose ? "loose" : name(report.status); }
  /// Σ Qi and Σ Qo over all rollers [N].
  [[nodiscard]] double inner_sum() const;
  [[nodiscard]] double outer_sum() const;
  /// Number of rollers that touch the inner ring [1].
  [[nodiscard]] int loaded_rollers() const;
  /// Largest load of a slice at one race [N].
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
/// s is the radial clearance, P is roller_relief(), c1 is as in LineContact, and u and f are shift
/// and tilt of a roller (LoadedRoller).
///
/// The equilibrium is the minimum of a convex energy of ring and rollers. Newton's method solves
/// for all unknowns, with a line search on the derivative of the energy along the step. The two
/// unknowns of each roller are eliminated. Ki and Ko are the contact stiffnesses of a roller. B
/// maps the ring displacement to the approach and tilt of the raceways at the roller. If Ki + Ko is
/// singular because the roller touches with a single slice, K uses the pseudo-inverse.
///
/// Source:   at rest the formulas of [ISO16281], as two other programs implement them; the series
///           connection of the contacts and the terms with the centrifugal force Fc are derived.
/// Domain:   speed >= 0. The function throws std::invalid_argument unless axial_load is 0. If there
///           is no load and no roller touches the inner ring, the status is `loose`. The ring does
///           not move in a direction without stiffness, for example perpendicular to the load of a
///           single loaded roller.
/// Accuracy: the relative imbalance is at most `tolerance`. The model assumes rigid rings and
///           quasi-static motion. The model ignores roller skew, flange friction, cage slip and
///           film. An approach below 1e-15 m is not a contact. Otherwise a rounding error of 1e-19
///           mm at a roller 90 deg from the load would contribute 1 % of the stiffness of a loaded
///           slice, because dq/dδ is proportional to the ninth root of the approach δ.
[[nodiscard]] RollerEquilibrium solve_roller_bearing(const RollerBearing& bearing,
                                                     const OperatingPoint& point,
                                                     const RollerOptions& options = {});

class RollerBalance;

/// Finds the equilibrium of the rollers for a given displacement of the inner ring. The
/// displacement has the five coordinates of DisplacedBearing; the axial coordinate has no effect.
/// Use this class for many displacements and clearances. Each solve starts from the previous
/// solution. The bearing must exist as long as the object.
class DisplacedRollerBearing {
 public:
  /// If `clearance` is NaN, the clearance of the geometry is used.
  DisplacedRollerBearing(const RollerBearing& bearing, double speed, double clearance = unset);
  DisplacedRollerBearing(DisplacedRollerBearing&&) noexcept;
  DisplacedRollerBearing& operator=(DisplacedRollerBearing&&) noexcept;
  ~DisplacedRollerBearing();

  void set_clearance(double clearance);
  /// Finds the equilibrium of the rollers at this displacement of the inner ring. Returns false if
  /// no equilibrium is found; force and stiffness are then invalid.
  [[nodiscard]] bool hold(const Vector5& displacement);
  /// External forces on the ring that balance the roller forces: F_x = 0, F_y, F_z [N], M_y, M_z
  /// [N m].
  [[nodiscard]] const Vector5& force() const { return force_; }
  /// Tangent stiffness ∂force/∂displacement with the rollers in equilibrium [SI].
  [[nodiscard]] const Matrix5& stiffness() const { return stiffness_; }
  /// Returns all results at the last displacement.
  [[nodiscard]] RollerEquilibrium equilibrium() const;

 private:
  double clearance_;
  std::unique_ptr<RollerBalance> balance_;
  SolveReport report_;
  Vector5 force_ = Vector5::Constant(unset);
  Matrix5 stiffness_ = Matrix5::Constant(unset);
};

/// Finds the equilibrium of the rollers at a given displacement of the inner ring. `load` of the
/// result is the external load at this displacement. If `clearance` is NaN, the clearance of the
/// geometry is used.
[[nodiscard]] RollerEquilibrium displaced_roller_bearing(const RollerBearing& bearing,
                                                         const Vector4& displacement, double speed,
                                                         double clearance = unset);

/// Largest Hertz pressures over all slices [Pa]; 0 for a race without contact, NaN if the
/// equilibrium did not converge.
[[nodiscard]] ContactPressure largest_pressure(const RollerBearing& bearing,
                                               const RollerEquilibrium& equilibrium);

/// Hertz pressure that defines the static rating of roller bearings [Pa]. Source: [ISO76].
inline constexpr double static_limit_pressure_of_lines = 4000e6;

/// Approximate ring tilt above which the roller ends are overloaded [rad]; from memory, without a
/// source.
inline constexpr double usual_tilt_limit = 1.2e-3;

}  // namespace raceway::bearing
