#pragma once

#include <span>
#include <vector>

#include "record/units.h"

/// Fits gain K and time constant T of step responses as functions of the power loss P or of a load.
namespace raceway::spindle {

/// Straight line, value = slope P + offset, fitted by unweighted least squares. P is a power loss
/// or a load.
struct StraightLine {
  double slope = unset, offset = unset;
  /// Standard errors of slope and offset, from the residuals; NaN with fewer than three points.
  double slope_std = unset, offset_std = unset;
  [[nodiscard]] double operator()(double power) const { return slope * power + offset; }
};

/// Power law, value = factor P^exponent, fitted by least squares of logarithms. All points
/// therefore have equal relative weight.
struct PowerLaw {
  double factor = unset, exponent = unset;
  /// Standard error of the exponent; NaN with fewer than three points.
  double exponent_std = unset;
  double rms = unset;  ///< RMS of the relative residuals [1]
  [[nodiscard]] double operator()(double power) const;
};

/// Piecewise cubic curve through points (x, y). The curve has maxima and minima only at the points.
/// Below the first and above the last x, the curve is constant.
///
/// Source:   [FritschCarlson1980].
class MonotoneCurve {
 public:
  /// Throws std::invalid_argument if there are no points, if x and y have different lengths, or if
  /// x is not strictly ascending.
  MonotoneCurve(std::vector<double> x, std::vector<double> y);
  [[nodiscard]] double operator()(double x) const;
  [[nodiscard]] const std::vector<double>& x() const { return x_; }
  [[nodiscard]] const std::vector<double>& y() const { return y_; }

 private:
  std::vector<double> x_, y_, slope_;
};

/// Gain and time constant of a step response at one power loss or load.
struct LagAt {
  double input = unset;          ///< power loss [W] or load [N]
  double gain = unset;           ///< [m]
  double time_constant = unset;  ///< [s]
};

/// Laws for the gain K(P) and the time constant T(P). All values are NaN for fewer than two
/// different values of P.
///
/// Source:   straight lines from [Brecher2021, eq. 8 and 9].
/// Traps:    a straight line is valid only between the fitted points. K(0) of the line has no
///           physical meaning, and the line of T may reach zero at large P.
struct PowerLaws {
  StraightLine gain_line = {}, time_line = {};  ///< slopes [m/W], [s/W]; offsets [m], [s]
  /// Power laws for the gain K and the time constant T. All members of both laws are NaN if a value
  /// of P is not above 0. A law is also NaN if its fitted values (gains or time constants) do not
  /// all have the same sign.
  PowerLaw gain_power = {}, time_power = {};
  /// Range of P >= 0 in which `gain_line` has the sign of the fitted gains and `time_line` is
  /// positive [W]. `valid_to` may be infinite.
  double valid_from = unset, valid_to = unset;
};

/// Fits the laws of PowerLaws to measured gains and time constants. The points may be in any order.
/// Throws std::invalid_argument for a negative power and for a value that is not finite.
[[nodiscard]] PowerLaws fit_power_laws(std::span<const LagAt> points);
/// Fits the laws of PowerLaws with a load instead of the power P. The load may be positive or
/// negative.
[[nodiscard]] PowerLaws fit_load_laws(std::span<const LagAt> points);

/// Returns a curve of the gain K through all points and through K(0) = 0. At zero power or load,
/// the curve is 0 even if one of the points gives another gain there. Points with equal power or
/// load are averaged.
[[nodiscard]] MonotoneCurve gain_curve(std::span<const LagAt> points);
/// Returns a curve of the time constant T through all points. `at_rest` is T at zero power or load
/// [s]; NaN if unknown. If one of the points has zero power or load, the curve uses this point
/// instead of `at_rest`.
[[nodiscard]] MonotoneCurve time_curve(std::span<const LagAt> points, double at_rest = unset);

}  // namespace raceway::spindle
