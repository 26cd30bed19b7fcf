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
  /// axial shaft displacement from standstill, positive towards the tool [m]
  double displacement = unset;
  double std = unset;  ///< standard deviation, if known [m]
};

/// Bounds of the law's parameters, in its published units. With B above 1 the displacement at
/// standstill is not zero; with B below 0 the curve has another shape. For C n_max below 0.01 the
/// law is a plain power; above 100 it is a straight line. These limits are the bounds of C if no
/// bounds are set. A may have any size and sign (negative for a mirrored layout).
struct KinematicLawBounds {
  double lower_B = 0.0, upper_B = 1.0;
  double lower_C = unset, upper_C = unset;  ///< [1/rpm]
};

/// Largest mean absolute error at which the verdict is `follows`: the error of the published fit
/// [Brecher2021, section 4.2] and also, for small displacements, a share of the largest
/// displacement. The error must be within both limits.
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
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Constant(unset);  ///< NaN without a standard error
  double mae = unset;                                              ///< mean absolute error [m]
  double max_abs = unset;                                          ///< largest absolute error [m]
  double speed_of_max_abs = unset;                                 ///< [rad/s]
  double largest = unset;      ///< largest absolute displacement [m]
  double scatter = unset;      ///< scatter of neighbouring rows about a smooth curve [m]
  double misfit = unset;       ///< rms of law minus reading, with the weights of the fit [1 or m]
  double standstill = 0.0;     ///< largest reading at standstill, where the law is 0 [m]
  int rows = 0;                ///< fitted rows, with a speed above 0
  int rows_at_standstill = 0;  ///< rows not used for the fit and the errors
  bool weighted = false;       ///< true if rows are weighted by their standard deviation
  int iterations = 0;
  fit::FitStatus status = fit::FitStatus::not_run;
  KinematicLawVerdict verdict = KinematicLawVerdict::stiff;
  std::vector<record::Note> notes;  ///< notes for the user

  [[nodiscard]] bool converged() const { return status == fit::FitStatus::converged; }
};

/// Returns "follows", "scatter" or "stiff".
[[nodiscard]] std::string_view name(KinematicLawVerdict verdict);

/// Fits the law to a curve by variable projection: minimises Σ (u(n) - u_measured)² / std². Weights
/// are equal unless every row has a std.
///
/// The law is linear in A, which is eliminated. For each C of a grid, the best B is found on a grid
/// and then to full accuracy. From each minimum of this profile over C, Ceres optimises all three
/// parameters; the lowest result is used. The fit therefore needs no start value.
///
/// Standard errors come from the linearised problem. Without std, the misfit sets their scale. With
/// std, the standard errors are increased if the misfit exceeds std. A computed curve has no
/// scatter. The standard errors of a computed curve show how well this curve determines the
/// parameters. These standard errors are not valid for other curves.
///
/// Rows at standstill are not fitted, because the law is zero there. Rows at standstill extend the
/// range of the law to zero. Throws std::invalid_argument for a value that is not finite, a
/// negative speed, a std that is not positive, fewer than four different speeds above zero, only
/// zero displacements, and invalid bounds.
[[nodiscard]] KinematicLawFit fit_kinematic_law(std::span<const DisplacementPoint> curve,
                                                const KinematicLawBounds& bounds = {});

/// Fits the law from one start (B and C; A is eliminated) without the grid, and returns the nearest
/// optimum. Use it to check that fit_kinematic_law() returns the lowest optimum.
[[nodiscard]] KinematicLawFit refine_kinematic_law(std::span<const DisplacementPoint> curve,
                                                   const KinematicLaw& start,
                                                   const KinematicLawBounds& bounds = {});

}  // namespace raceway::shaft
