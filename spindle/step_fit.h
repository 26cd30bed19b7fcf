#pragma once

#include <span>
#include <vector>

#include "record/units.h"

namespace raceway::spindle {

/// One minute [s], the unit of time constants in results of step responses.
inline constexpr double one_minute = 60.0;

/// Response of a body to a step: gain (1 - exp(-t/time_constant)).
struct Lag {
  double gain = unset;           ///< final displacement [m]
  double time_constant = unset;  ///< [s]
};

/// Fits of a step response with one lag and with two.
struct StepFit {
  Lag one = {};
  double rms = unset;  ///< rms residual of one lag over all rows [m]
  /// The faster lag comes first; NaN if the rows do not determine two different lags.
  Lag fast = {}, slow = {};
  double rms_of_two = unset;  ///< [m]
  /// True if the residual of one lag exceeds a hundredth of the gain, and the residual of two lags
  /// is less than half the residual of one lag.
  bool two_needed = false;
  /// True if the record is longer than two time constants of the single lag. Otherwise, gain and
  /// time constant are extrapolated.
  bool settled = false;
};

/// Fits u(t) = K (1 - exp(-t/T)), and a sum of two such lags, to a step at t = 0 with equal
/// weights.
///
/// Source:   [Brecher2021, eq. 7].
/// Method:   variable projection. Gains come from linear least squares at each time constant. Time
///           constants come from a logarithmic grid and then from Gauss-Newton iterations with
///           Kaufman's derivatives. The fit needs no start values.
/// Domain:   one lag needs at least two rows at different times t > 0, and two lags need six. Rows
///           may have any order and spacing, with t >= 0 [s]. T is limited to the range from a
///           tenth of the first time to thirty times the last.
/// Accuracy: time constants to 1e-9 if the rows follow the law exactly.
/// Traps:    subtract the kinematic part from the displacement first, because this immediate part
///           would look like a fast lag. Throws std::invalid_argument for too few rows, for a value
///           that is not finite, for a negative time, and if all displacements are zero.
[[nodiscard]] StepFit fit_step(std::span<const double> time, std::span<const double> displacement);

/// Returns the time constants of one or two lags with known gains that decay to zero [s].
///
///   u(t) = Σ K_k exp(-t/T_k)
///
/// A delay element needs these time constants at rest. With free gains, the lags of the decay would
/// not correspond to the lags of the step.
/// Method:   a logarithmic grid that is refined around its best point, from a tenth of the first
///           time to thirty times the last.
/// Accuracy: 1e-6 if the rows follow the law exactly. Throws std::invalid_argument like fit_step(),
/// and unless there are one or two gains.
[[nodiscard]] std::vector<double> fit_decay(std::span<const double> time,
                                            std::span<const double> displacement,
                                            std::span<const double> gains);

/// Returns the displacement of a lag at a time after the step [m].
[[nodiscard]] double displacement_at(const Lag& lag, double time);

}  // namespace raceway::spindle
