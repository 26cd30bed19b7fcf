#pragma once

#include <span>
#include <vector>

#include "record/units.h"

namespace raceway::spindle {

/// Files have time constants in minutes [s].
inline constexpr double one_minute = 60.0;

/// Response of a body to a step: gain (1 - exp(-t/time_constant)).
struct Lag {
  double gain = unset;           ///< where it leads to [m]
  double time_constant = unset;  ///< [s]
};

/// A step response as one lag and as two.
struct StepFit {
  Lag one = {};
  double rms = unset;  ///< that one lag leaves, over all rows [m]
  /// The faster one first; NaN where the rows do not carry two that differ.
  Lag fast = {}, slow = {};
  double rms_of_two = unset;  ///< [m]
  /// One leaves more than a hundredth of its gain, and two less than half of that.
  bool two_needed = false;
  /// True if the record covers two time constants of the one lag. Otherwise gain and time constant
  /// are extrapolated.
  bool settled = false;
};

/// Fits u(t) = K (1 - exp(-t/T)) to a step at t = 0, all rows alike, and the sum of two of them.
///
/// Source:   [Brecher2021, eq. 7].
/// Method:   variable projection: gains by linear least squares at each time constant; these from
///           a grid of logarithms, then by Gauss and Newton with Kaufman's derivatives. The answer
///           needs no start.
/// Domain:   two rows after t = 0 at two times for one lag, six for two; rows in any order and of
///           any spacing, t >= 0 [s]. T from a tenth of the first time to thirty times the last.
/// Accuracy: time constants to 1e-9 where the rows are of the law.
/// Traps:    the displacement is that less its kinematic part, which is there at once and would
///           pass for a fast lag.
/// Throws std::invalid_argument: too few rows, a value that is not finite, a time below 0,
/// displacements that are all zero.
[[nodiscard]] StepFit fit_step(std::span<const double> time, std::span<const double> displacement);

/// Time constants of one or two lags that fall from their gains to zero, as the gains are [s].
///
///   u(t) = Σ K_k exp(-t/T_k)
///
/// A delay element needs these at rest: free gains would split a decay into other lags than the
/// step before it.
/// Method:   on a grid of logarithms that closes in on its best point, from a tenth of the first
///           time to thirty times the last.
/// Accuracy: 1e-6 where the rows are of the law.
/// Throws std::invalid_argument as fit_step(), and for other than one or two gains.
[[nodiscard]] std::vector<double> fit_decay(std::span<const double> time,
                                            std::span<const double> displacement,
                                            std::span<const double> gains);

/// Displacement of a lag at a time after the step [m].
[[nodiscard]] double displacement_at(const Lag& lag, double time);

}  // namespace raceway::spindle
