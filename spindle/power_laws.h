#pragma once

#include <span>
#include <vector>

#include "record/units.h"

/// Fits gain and time constant of step responses as functions of the power loss P or of a load.
namespace raceway::spindle {

/// value = slope P + offset, by unweighted least squares.
struct StraightLine {
  double slope = unset, offset = unset;
  /// Standard errors, from the residual; NaN with fewer than three points.
  double slope_std = unset, offset_std = unset;
  [[nodiscard]] double operator()(double power) const { return slope * power + offset; }
};

/// value = factor P^exponent, by least squares of logarithms, so all points have equal relative
/// weight.
struct PowerLaw {
  double factor = unset, exponent = unset;
  double exponent_std = unset;
  double rms = unset;  ///< rms residual relative to the value [1]
  [[nodiscard]] double operator()(double power) const;
};

/// Curve of cubics through points. The curve has maxima and minima only at the points. Outside the
/// points, the end values are used.
///
/// Source:   [FritschCarlson1980].
class MonotoneCurve {
 public:
  /// Throws std::invalid_argument if there are no points, if x and y have different lengths, or if
  /// x is not in ascending order.
  MonotoneCurve(std::vector<double> x, std::vector<double> y);
  [[nodiscard]] double operator()(double x) const;
  [[nodiscard]] const std::vector<double>& x() const { return x_; }
  [[nodiscard]] const std::vector<double>& y() const { return y_; }

 private:
  std::vector<double> x_, y_, slope_;
};

/// Gain and time constant at one power or load.
struct LagAt {
  double input = unset;          ///< [W], [N]
  double gain = unset;           ///< [m]
  double time_constant = unset;  ///< [s]
};

/// Laws K(P) and T(P). All values are NaN for fewer than two different powers.
///
/// Source:   lines from [Brecher2021, eq. 8 and 9].
/// Traps:    a straight line is only a chord of the true curve. K(0) of a line has no physical
///           meaning, and T of a line may reach zero.
struct PowerLaws {
  StraightLine gain_line = {}, time_line = {};  ///< [m/W], [m]; [s/W], [s]
  PowerLaw gain_power = {}, time_power = {};    ///< NaN if a power is 0 or if signs differ
  /// Range of P in which both lines have the same sign as between the points [W]; from 0 to
  /// infinity if the sign never changes.
  double valid_from = unset, valid_to = unset;
};

/// Fits laws to points in any order. Throws std::invalid_argument for a negative power and for a
/// value that is not finite.
[[nodiscard]] PowerLaws fit_power_laws(std::span<const LagAt> points);
/// Fits laws over loads, which may have either sign.
[[nodiscard]] PowerLaws fit_load_laws(std::span<const LagAt> points);

/// Returns a curve of K through all points and through K(0) = 0. Points with equal power or load
/// are averaged.
[[nodiscard]] MonotoneCurve gain_curve(std::span<const LagAt> points);
/// Returns a curve of T through all points. `at_rest` [s] is the value at 0, if it is known.
[[nodiscard]] MonotoneCurve time_curve(std::span<const LagAt> points, double at_rest = unset);

}  // namespace raceway::spindle
