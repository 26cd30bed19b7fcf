#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "record/note.h"
#include "record/units.h"
#include "shaft/kinematic_law.h"
#include "verdict/calibrate.h"

namespace raceway::shaft {

/// One computed or measured point of a displacement curve.
struct DisplacementPoint {
  double speed = unset;  ///< [rad/s], >= 0
  /// Axial shaft displacement from standstill, positive towards the tool [m].
  double displacement = unset;
  double std = unset;  ///< standard deviation, if known [m]
};

/// Bounds of the parameters B and C of the law, in the published units. With B above 1 the law
/// tends to infinity towards standstill. With B below 0 the exponent of the speed falls with the
/// speed instead of rising. For C n_max below 0.01 (n_max: highest speed) the law is nearly a power
/// of the speed; above 100 it is nearly a straight line. The default bounds of C are therefore
/// 0.01/n_max and 100/n_max. A has no bounds; A is negative if the shaft moves away from the tool.
struct KinematicLawBounds {
  double lower_B = 0.0, upper_B = 1.0;
  double lower_C = unset, upper_C = unset;  ///< [1/rpm]
};

/// Limits of the mean absolute error for the verdict `follows`: the error of the published fit
/// [Brecher2021, section 4.2], and a share of the largest displacement. The error must be within
/// both limits.
inline constexpr double kinematic_law_tolerance = 0.023e-6;  ///< [m]
inline constexpr double kinematic_law_share = 0.01;          ///< [1]

enum class KinematicLawVerdict {
  follows,  ///< mean absolute error within both limits
  scatter,  ///< error above a limit, with residuals that scatter from row to row
  stiff     ///< error above a limit, with smooth residuals: the law cannot follow the shape
};

struct KinematicLawFit {
  KinematicLaw law;
  /// A, B and C with value, standard error and bounds, in published units.
  std::array<record::Parameter, 3> parameters;
  /// Correlation of A, B and C; NaN for a parameter without standard error.
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Constant(unset);
  double mae = unset;               ///< mean absolute error [m]
  double max_abs = unset;           ///< largest absolute error [m]
  double speed_of_max_abs = unset;  ///< speed of the largest absolute error [rad/s]
  double largest = unset;           ///< largest absolute displacement [m]
  double scatter = unset;           ///< scatter of neighbouring rows about a smooth curve [m]
  /// RMS of law minus reading [m]. If `weighted` is true, each difference is divided by its
  /// standard deviation [1].
  double misfit = unset;
  double standstill = 0.0;     ///< largest reading at standstill, where the law is 0 [m]
  int rows = 0;                ///< fitted rows, with a speed above 0
  int rows_at_standstill = 0;  ///< rows at standstill, not used for the fit and the errors
  bool weighted = false;       ///< true if rows are weighted by their standard deviation
  int iterations = 0;
  fit::FitStatus status = fit::FitStatus::not_run;
  KinematicLawVerdict verdict = KinematicLawVerdict::stiff;
  std::vector<record::Note> notes;  ///< notes for the user

  [[nodiscard]] bool converged() const { return status == fit::FitStatus::converged; }
};

/// Returns the name of the verdict: "follows", "scatter" or "stiff".
[[nodiscard]] std::string_view name(KinematicLawVerdict verdict);

/// Fits the law to a curve by variable projection. The fit minimises Σ (u(n) - u_measured)² / std².
/// The weights are equal unless every row has a `std`.
///
/// The law is linear in A, so the search over B and C finds A by linear least squares. For each C
/// of a grid, the best B is found on a grid and then to full accuracy. From each minimum of the
/// resulting misfit over C, the solver Ceres optimises all three parameters. The result with the
/// smallest misfit is used. The fit therefore needs no start value.
///
/// The standard errors come from the linearised problem. Without `std`, the misfit determines the
/// scale of the standard errors. With `std`, the standard errors are increased if the reduced
/// chi-square of the fit is above 1. A computed curve has no scatter, so standard errors from such
/// a curve are not valid for other curves.
///
/// Rows at standstill are not fitted, because the law is zero there. They extend the speed range of
/// the law to zero. Throws std::invalid_argument for a value that is not finite, a negative speed,
/// a `std` that is not positive, fewer than four different speeds above zero, only zero
/// displacements above standstill, and invalid bounds.
[[nodiscard]] KinematicLawFit fit_kinematic_law(std::span<const DisplacementPoint> curve,
                                                const KinematicLawBounds& bounds = {});

/// Fits the law from one start of B and C without the grid, and returns the nearest optimum. Use
/// this function to check that fit_kinematic_law() returns the lowest optimum.
[[nodiscard]] KinematicLawFit refine_kinematic_law(std::span<const DisplacementPoint> curve,
                                                   const KinematicLaw& start,
                                                   const KinematicLawBounds& bounds = {});

}  // namespace raceway::shaft
