#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "record/units.h"

namespace raceway::correction {

/// A transfer function as papers and controls print it, at one sampling time.
///
///   y(k) = sum a(i) u(k-i) - sum b(i) y(k-i),   b(0) = 1
///
/// Source:   [Transfer2022, eq. 1], [S3]; a in um/K (not um/(s K), as printed), here [m/K].
/// Traps:    slow poles lie so near 1 that printed digits decide gain and stability: a sampling of
///           1 s with time constants of 5400 and 900 s leaves a sum of the denominator of 2e-7. It
///           is therefore read, checked and run, and never identified: that is done in sections.
struct TransferFunction {
  std::vector<double> numerator, denominator;
  double sampling = unset;  ///< [s]
};

/// Cancels a common root of numerator and denominator at exactly 1: a pole that never decays,
/// cancelled on paper, drifts away in numbers. Throws std::invalid_argument: no coefficient, b(0)
/// that is not 1, one that is not finite, sampling that is not positive.
[[nodiscard]] TransferFunction reduced(const TransferFunction& printed);

/// The reduced function with the numerator as people print it, in um per `unit` [SI] of the input,
/// and both polynomials alike long. Coefficients have 15 digits: with slow poles a digit beyond
/// them moves the gain by 1e-9, so everything that runs the function runs these numbers.
[[nodiscard]] TransferFunction direct_form(const TransferFunction& printed, double unit);

/// Response to an input sampled at the function's own rate, from rest, in double precision.
[[nodiscard]] std::vector<double> run(const TransferFunction& printed,
                                      std::span<const double> input);
/// Response as a controller with single precision computes it, unreduced.
[[nodiscard]] std::vector<float> run_single(const TransferFunction& printed,
                                            std::span<const float> input);

/// A transfer function as a sum of lags of the previous input sample, and of a direct feedthrough.
///
///   y(k) = through u(k) + sum x_i(k),   x_i(k) = x_i(k-1) + rise_i (gain_i u(k-1) - x_i(k-1))
///
/// Source:   partial fractions in z^-1, of the reduced function.
/// Domain:   poles real, between 0 and 1 (open) and apart; a numerator no longer than the
///           denominator.
/// Accuracy: limited by the poles; they are found in extended precision, since poles of slow bodies
///           lie within 1e-4 of each other.
/// Traps:    the same numbers only at the sampling of the function; there a lag has the time
///           constant -dt/ln(1 - rise), and its input is held between samples.
struct ParallelForm {
  struct Lag {
    double rise, gain;  ///< 1 - pole [1]; in the unit of a(0)
  };
  double through = 0.0;  ///< in the unit of a(0)
  std::vector<Lag> lags{};
};

/// Throws std::invalid_argument saying which pole stands against it.
[[nodiscard]] ParallelForm parallel_form(const TransferFunction& printed);

/// Meaning of poles that no body has, a sentence each: on or outside the unit circle, negative,
/// complex.
[[nodiscard]] std::vector<std::string> pole_warnings(const TransferFunction& printed);

/// True where a pole of the reduced function lies on or outside the unit circle.
[[nodiscard]] bool never_decays(const TransferFunction& printed);

/// Properties of printed coefficients.
struct TransferFunctionCheck {
  std::vector<std::complex<double>> poles{};  ///< as printed, the largest first
  std::vector<double> time_constants{};       ///< of each pole [s]; NaN for one that is no decay
  double dc_gain = unset;                     ///< in the unit of a(0)
  /// Range of the gain when the last printed digit of every coefficient is rounded: 5th and 95th
  /// percentile of 4000 draws, and the share of draws that are unstable.
  double dc_gain_lower = unset, dc_gain_upper = unset;
  double unstable_share = unset;
  double feedthrough = unset;   ///< a(0): the part of a step that arrives at once
  double single_error = unset;  ///< of a step after 40 h in single precision, over the gain [1]
  std::vector<std::string> warnings{};  ///< for people, a sentence each
};

/// Checks printed coefficients. `quantum`: resolution of the input's sensor, in its unit;
/// `unit` of the displacement: a step of more than a tenth of it is reported.
[[nodiscard]] TransferFunctionCheck check(const TransferFunction& printed, double quantum = 0.1,
                                          std::string_view unit = "um");

}  // namespace raceway::correction
