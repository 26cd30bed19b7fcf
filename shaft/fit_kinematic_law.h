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

/// One point of a displacement curve, computed or measured.
struct DisplacementPoint {
  double speed = unset;         ///< [rad/s], >= 0
  double displacement = unset;  ///< axial, of the shaft from standstill, towards the tool [m]
  double std = unset;           ///< its standard deviation where known [m]
};

/// Bounds of the law's parameters, in its published units. B above 1 has no displacement at
/// standstill, below 0 another shape. C n_max below 0.01 is a plain power, above 100 a straight
/// line: unset ends stand for these. A is free in size and sign (negative where the layout is
/// mirrored).
struct KinematicLawBounds {
  double lower_B = 0.0, upper_B = 1.0;
  double lower_C = unset, upper_C = unset;  ///< [1/rpm]
};

/// Up to which mean absolute error the law follows a curve: the published fit's [Brecher2021,
/// section 4.2], and for small displacements this share of the largest one.
inline constexpr double kinematic_law_tolerance = 0.023e-6;  ///< [m]
inline constexpr double kinematic_law_share = 0.01;          ///< [1]

enum class KinematicLawVerdict {
  follows,  ///< mean absolute error within tolerance and share
  scatter,  ///< above, but the residual jumps from row to row: scatter, not shape
  stiff     ///< above, and the residual is smooth: the law cannot take the shape of the curve
};

struct KinematicLawFit {
  KinematicLaw law;
  /// A, B, C: value, standard error, bounds, in published units.
  std::array<record::Parameter, 3> parameters;
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Constant(unset);  ///< NaN where no std error is
  double mae = unset;                                              ///< mean absolute error [m]
  double max_abs = unset;                                          ///< largest absolute error [m]
  double speed_of_max_abs = unset;                                 ///< [rad/s]
  double largest = unset;      ///< displacement by magnitude [m]
  double scatter = unset;      ///< of neighbours about a smooth course [m]
  double misfit = unset;       ///< rms of law minus reading, weighted as the fit was [1 or m]
  double standstill = 0.0;     ///< largest reading at standstill, which the law takes as 0 [m]
  int rows = 0;                ///< fitted: those with a speed
  int rows_at_standstill = 0;  ///< left out of fit and errors
  bool weighted = false;       ///< by the standard deviation of the rows
  int iterations = 0;
  fit::FitStatus status = fit::FitStatus::not_run;
  KinematicLawVerdict verdict = KinematicLawVerdict::stiff;
  std::vector<record::Note> notes;  ///< what the user should know

  [[nodiscard]] bool converged() const { return status == fit::FitStatus::converged; }
};

/// "follows", "scatter" or "stiff".
[[nodiscard]] std::string_view name(KinematicLawVerdict verdict);

/// Fits the law to a curve by variable projection: minimise Σ (u(n) - u_measured)² / std², with
/// equal weights unless every row has a std.
///
/// The law is linear in A alone, and A is eliminated. On a grid in C the best B is found, on a grid
/// and then to full accuracy; from each minimum of that profile of C, Ceres runs on all three
/// parameters, and the lowest end wins. So the result needs no start and depends on none.
///
/// Standard errors follow from the linearised problem. Without std the misfit sets their scale;
/// with std, a misfit above them widens them. On a computed curve, which has no scatter, they show
/// how sharply the curve defines the parameters and nothing about other curves.
///
/// Rows at standstill are not fitted: the law is zero there. They extend its range to zero.
/// Throws std::invalid_argument: a value that is not finite, negative speed, std not positive, less
/// than four different speeds above zero, all displacements zero, bounds that are none.
[[nodiscard]] KinematicLawFit fit_kinematic_law(std::span<const DisplacementPoint> curve,
                                                const KinematicLawBounds& bounds = {});

/// Fits the law from one start (its B and C; A is eliminated), without the grid: the nearest
/// optimum. Checks that fit_kinematic_law() returns the lowest.
[[nodiscard]] KinematicLawFit refine_kinematic_law(std::span<const DisplacementPoint> curve,
                                                   const KinematicLaw& start,
                                                   const KinematicLawBounds& bounds = {});

}  // namespace raceway::shaft
