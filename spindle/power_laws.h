#pragma once

#include <span>
#include <vector>

#include "record/units.h"

/// Gain and time constant of a step response as laws of the power loss P, or of a load.
namespace raceway::spindle {

/// value = slope P + offset, by least squares, all points alike.
struct StraightLine {
  double slope = unset, offset = unset;
  double slope_std = unset, offset_std = unset;  ///< by what it leaves; NaN below three points
  [[nodiscard]] double operator()(double power) const { return slope * power + offset; }
};

/// value = factor P^exponent, by least squares of logarithms: all points alike in proportion.
struct PowerLaw {
  double factor = unset, exponent = unset;
  double exponent_std = unset;
  double rms = unset;  ///< that it leaves, as a share of the value [1]
  [[nodiscard]] double operator()(double power) const;
};

/// A curve through points that turns only where they turn, by cubics between them; the ends hold
/// outside.
///
/// Source:   [FritschCarlson1980].
class MonotoneCurve {
 public:
  /// Throws std::invalid_argument: no point, lengths that differ, x that does not rise.
  MonotoneCurve(std::vector<double> x, std::vector<double> y);
  [[nodiscard]] double operator()(double x) const;
  [[nodiscard]] const std::vector<double>& x() const { return x_; }
  [[nodiscard]] const std::vector<double>& y() const { return y_; }

 private:
  std::vector<double> x_, y_, slope_;
};

/// Gain and time constant at one power, or one load.
struct LagAt {
  double input = unset;          ///< [W], [N]
  double gain = unset;           ///< [m]
  double time_constant = unset;  ///< [s]
};

/// The laws K(P) and T(P). NaN where the points do not carry them: below two powers.
///
/// Source:   lines: [Brecher2021, eq. 8 and 9].
/// Traps:    a line is a chord: K(0) of it is no physics, and its T ends where it reaches zero.
struct PowerLaws {
  StraightLine gain_line = {}, time_line = {};  ///< [m/W], [m]; [s/W], [s]
  PowerLaw gain_power = {}, time_power = {};    ///< NaN where values differ in sign
  /// Range of P in which both lines keep the sign that they have between the points [W]; infinite
  /// where they always do.
  double valid_from = unset, valid_to = unset;
};

/// Laws of these points, in any order. Throws std::invalid_argument: a power below 0, a value that
/// is not finite.
[[nodiscard]] PowerLaws fit_power_laws(std::span<const LagAt> points);
/// Laws over loads, which may have either sign.
[[nodiscard]] PowerLaws fit_load_laws(std::span<const LagAt> points);

/// K through all points and through K(0) = 0. Of points of one power or load the mean.
[[nodiscard]] MonotoneCurve gain_curve(std::span<const LagAt> points);
/// T through all points; `at_rest` [s] is that at 0, where it is known.
[[nodiscard]] MonotoneCurve time_curve(std::span<const LagAt> points, double at_rest = unset);

}  // namespace raceway::spindle
