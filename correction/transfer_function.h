#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "record/units.h"

namespace raceway::correction {

/// Transfer function with coefficients as papers and controls print them, for one sampling time.
///
///   y(k) = sum a(i) u(k-i) - sum b(i) y(k-i),   b(0) = 1
///
/// Source:   [Transfer2022, eq. 1], [S3]; a in um/K (not um/(s K), as printed), here [m/K].
/// Traps:    slow poles are so close to 1 that the printed digits determine gain and stability.
///           With a sampling time of 1 s and time constants of 5400 and 900 s, the coefficients of
///           the denominator have a sum of only 2e-7. The program therefore reads, checks and runs
///           transfer functions, but identify() uses sections. Only the ARX baseline fits transfer
///           functions, for comparison.
struct TransferFunction {
  std::vector<double> numerator, denominator;
  double sampling = unset;  ///< [s]
};

/// Returns the function without a common root of numerator and denominator at exactly 1. A pole at
/// 1 never decays. In exact arithmetic, the two roots cancel, but the numerical result drifts.
/// Throws std::invalid_argument if a polynomial is empty, b(0) is not 1, a coefficient is not
/// finite, or the sampling time is not positive.
[[nodiscard]] TransferFunction reduced(const TransferFunction& printed);

/// Returns the reduced function with a numerator in um per `unit` [SI] of the input and with two
/// polynomials of equal length. Coefficients have 15 digits. With slow poles, the omitted digits
/// change the gain by 1e-9. All programs that run the function therefore use these rounded
/// coefficients, so that their results agree.
[[nodiscard]] TransferFunction direct_form(const TransferFunction& printed, double unit);

/// Runs the function from rest in double precision. The input has the sampling time of the
/// function.
[[nodiscard]] std::vector<double> run(const TransferFunction& printed,
                                      std::span<const double> input);
/// Runs the function as a controller does: in single precision and without cancelling roots.
[[nodiscard]] std::vector<float> run_single(const TransferFunction& printed,
                                            std::span<const float> input);

/// Transfer function as the sum of a direct feedthrough and of lags that follow the previous input
/// sample.
///
///   y(k) = through u(k) + sum x_i(k),   x_i(k) = x_i(k-1) + rise_i (gain_i u(k-1) - x_i(k-1))
///
/// Source:   partial fractions of the reduced function in z^-1.
/// Domain:   the poles are real, distinct and in the open interval (0, 1). The numerator is not
///           longer than the denominator.
/// Accuracy: limited by the poles, which are found in extended precision because poles of slow
///           bodies lie within 1e-4 of each other.
/// Traps:    the two forms agree only at the sampling time dt of the function. A lag has the time
///           constant -dt/ln(1 - rise), and its input is held between samples.
struct ParallelForm {
  struct Lag {
    double rise, gain;  ///< rise: 1 - pole [1]; gain: in the unit of a(0)
  };
  double through = 0.0;  ///< in the unit of a(0)
  std::vector<Lag> lags{};
};

/// Throws std::invalid_argument if a pole prevents this form; the message names the pole.
[[nodiscard]] ParallelForm parallel_form(const TransferFunction& printed);

/// Returns one sentence for each kind of pole that no thermal body has: on or outside the unit
/// circle, negative, or complex.
[[nodiscard]] std::vector<std::string> pole_warnings(const TransferFunction& printed);

/// Returns true if a pole of the reduced function lies on or outside the unit circle.
[[nodiscard]] bool never_decays(const TransferFunction& printed);

/// Properties of published coefficients.
struct TransferFunctionCheck {
  std::vector<std::complex<double>> poles{};  ///< poles as printed, the largest first
  /// Time constant of each pole [s]; NaN unless the pole is real and between 0 and 1.
  std::vector<double> time_constants{};
  double dc_gain = unset;  ///< in the unit of a(0)
  /// Range of the gain from rounding the last printed digit of every coefficient: 5th and 95th
  /// percentile of 4000 draws, and the share of unstable draws.
  double dc_gain_lower = unset, dc_gain_upper = unset;
  double unstable_share = unset;
  double feedthrough = unset;  ///< a(0): instant part of the response to a step
  /// Error of the step response after 40 h in single precision, divided by the gain [1].
  double single_error = unset;
  std::vector<std::string> warnings{};  ///< warnings for the reader, one sentence each
};

/// Checks published coefficients. `quantum` is the resolution of the input's sensor in its unit.
/// `unit` is the unit of the displacement. A warning is added if one step of the resolution moves
/// the displacement by more than a tenth of this unit.
[[nodiscard]] TransferFunctionCheck check(const TransferFunction& printed, double quantum = 0.1,
                                          std::string_view unit = "um");

}  // namespace raceway::correction
