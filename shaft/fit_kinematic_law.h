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

/// Bounds of the parameters B and C of the kinematic law u = A n^(1 - B exp(-C n)), in its
/// published units (see kinematic_displacement_um()). u is the displacement and n the speed.
/// `upper_B` must not exceed 1: with B above 1, the displacement u would tend to infinity towards
/// standstill. With B below 0, the exponent of the speed falls with rising speed. If C n_max is
/// below 0.01 (n_max: highest speed), u is nearly a power of the speed. If C n_max is above 100, u
/// is nearly a straight line. The default bounds of C are therefore 0.01/n_max and 100/n_max. A has
/// no bounds. A is negative if the shaft moves away from the tool.
struct KinematicLawBounds {
  double lower_B = 0.0, upper_B = 1.0;
  double lower_C = unset, upper_C = unset;  ///< [1/rpm]
};

/// Limits of the mean absolute error for the verdict `follows`. The error must be within both
/// limits. The first limit is the error of the published fit [Brecher2021, section 4.2]. The second
/// limit is 1 % of the largest displacement.
inline constexpr double kinematic_law_tolerance = 0.023e-6;  ///< [m]
inline constexpr double kinematic_law_share = 0.01;          ///< [1]

enum class KinematicLawVerdict {
  follows,  ///< the mean absolute error is within both limits
  /// The mean absolute error is above a limit, and the residuals scatter randomly from row to row.
  scatter,
  /// The mean absolute error is above a limit, and the residuals are smooth, so the law cannot
  /// follow the curve.
  stiff
};

struct KinematicLawFit {
  KinematicLaw law;
  /// A, B and C with value, standard error and bounds, in the published units.
  std::array<record::Parameter, 3> parameters;
  /// Correlation matrix of A, B and C. If a parameter has no standard error, its row and column are
  /// NaN.
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Constant(unset);
  double mae = unset;               ///< mean absolute error [m]
  double max_abs = unset;           ///< largest absolute error [m]
  double speed_of_max_abs = unset;  ///< speed of the largest absolute error [rad/s]
  double largest = unset;           ///< largest absolute displacement [m]
  double scatter = unset;           ///< scatter of neighbouring rows about a smooth curve [m]
  /// RMS difference between law and reading [m]. If `weighted` is true, each difference is divided
  /// by the standard deviation of its reading, so that the RMS has no unit.
  double misfit = unset;
  /// Reading at standstill with the largest absolute value [m]. The law gives 0 at standstill.
  double standstill = 0.0;
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

/// Fits the kinematic law to a curve. The fit minimises Σ (u(n) - u_measured)² / std². All rows
/// have the same weight unless every row has a `std`.
///
/// The fit needs no start value. The law is linear in A, so linear least squares give A for each B
/// and C (variable projection). A grid search over B and C finds the local minima of the misfit.
/// From each of these minima, the solver Ceres optimises all three parameters. The function returns
/// the result with the smallest misfit.
///
/// The standard errors come from the linearised problem. If the rows have no `std`, the scatter for
/// the standard errors comes from the residuals. If the rows have a `std`, the standard errors are
/// increased if the reduced chi-square of the fit is above 1. The readings of a computed curve have
/// no random errors, so the standard errors of a fit to such a curve have no statistical meaning.
///
/// Rows at standstill are not fitted, because the law is zero there. If the curve has such rows,
/// the speed range of the law begins at zero. Throws std::invalid_argument for invalid bounds, for
/// a speed or displacement that is not finite, for a negative speed, and for a `std` that is not
/// positive. Throws also if the curve has fewer than four different speeds above zero, or if all
/// displacements at these speeds are zero.
[[nodiscard]] KinematicLawFit fit_kinematic_law(std::span<const DisplacementPoint> curve,
                                                const KinematicLawBounds& bounds = {});

/// Fits the kinematic law with one solver run from the values B and C of `start`, and returns the
/// local minimum of the misfit that the solver reaches. Use this function to check that
/// fit_kinematic_law() returns the lowest minimum.
[[nodiscard]] KinematicLawFit refine_kinematic_law(std::span<const DisplacementPoint> curve,
                                                   const KinematicLaw& start,
                                                   const KinematicLawBounds& bounds = {});

}  // namespace raceway::shaft
