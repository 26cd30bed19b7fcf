#pragma once

#include <span>
#include <vector>

#include "record/units.h"

namespace raceway::spindle {

/// One minute [s], the unit of time constants in result files and printed tables.
inline constexpr double one_minute = 60.0;

/// First-order lag with the step response gain (1 - exp(-t/time_constant)).
struct Lag {
  double gain = unset;           ///< final displacement [m]
  double time_constant = unset;  ///< [s]
};

/// Fits of one lag and of two lags to a step response.
struct StepFit {
  Lag one = {};
  double rms = unset;  ///< RMS residual of the fit with one lag [m]
  /// Faster and slower lag of the fit with two lags; NaN if the rows do not determine two different
  /// lags.
  Lag fast = {}, slow = {};
  double rms_of_two = unset;  ///< RMS residual of the fit with two lags [m]
  /// True if the fit needs two lags: the RMS residual with one lag exceeds 1 % of the magnitude of
  /// the gain of this lag, and `rms_of_two` is less than half of `rms`.
  bool two_needed = false;
  /// True if the last row lies at least two time constants of `one` after the step. Otherwise, the
  /// final displacement of the fit with one lag is an extrapolation.
  bool settled = false;
};

/// Fits one lag u(t) = K (1 - exp(-t/T)), and the sum of two such lags, to a step response with
/// equal weights of all rows. The step is at t = 0.
///
/// Source:   [Brecher2021, eq. 7].
/// Method:   linear least squares for the gains; a logarithmic grid, then Gauss-Newton iterations
///           for the time constants. No start values are needed.
/// Domain:   one lag needs at least two rows at different times t > 0, and two lags need at least
///           six rows with t > 0. Rows may have any order and spacing, with t >= 0 [s]. The time
///           constants are limited to the range from a tenth of the smallest time t > 0 to thirty
///           times the largest time.
/// Accuracy: relative error of the time constants 1e-9 if the rows follow u(t) exactly.
/// Traps:    subtract the kinematic displacement from the measured displacement before the fit,
///           because this immediate displacement would look like a fast lag. Throws
///           std::invalid_argument for too few rows, for a value that is not finite, for a negative
///           time, and if all displacements are zero.
[[nodiscard]] StepFit fit_step(std::span<const double> time, std::span<const double> displacement);

/// Returns the time constants T_k [s] of one or two lags. The displacement of each lag decays to
/// zero, beginning at t = 0.
///
///   u(t) = Σ K_k exp(-t/T_k)
///
/// The function does not fit the gains K_k: `gains` contains the gains of the step before the decay
/// [m], from fit_step(). Each lag of the decay therefore corresponds to a lag of this step.
/// Method:   a logarithmic grid from a tenth of the smallest time t > 0 to thirty times the largest
///           time, refined around its best point.
/// Accuracy: relative error of the time constants 1e-6 if the rows follow u(t) exactly. Throws
///           std::invalid_argument like fit_step(), and if the number of gains is not one or two.
[[nodiscard]] std::vector<double> fit_decay(std::span<const double> time,
                                            std::span<const double> displacement,
                                            std::span<const double> gains);

/// Returns the displacement of a lag [m] at the time `time` after the step [s].
[[nodiscard]] double displacement_at(const Lag& lag, double time);

}  // namespace raceway::spindle
