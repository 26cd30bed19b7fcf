#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "record/units.h"

namespace raceway::correction {

/// Discrete transfer function from an input u to a displacement y, with published coefficients that
/// are valid for one sampling time.
///
///   y(k) = sum_{i>=0} a(i) u(k-i) - sum_{i>=1} b(i) y(k-i),   b(0) = 1,   k: index of the sample
///
/// Source:   [Transfer2022, eq. 1], see docs/papers.md. The paper prints um/(s K) as the unit of a,
///           but the numbers are in um/K. This struct stores a in m/K.
/// Traps:    slow poles are so close to 1 that the last printed digits determine gain and
///           stability. With a sampling time of 1 s and time constants of 5400 and 900 s, the
///           coefficients of the denominator have a sum of only 2e-7. Therefore identify() fits
///           first-order lags. Only arx_baseline() fits transfer functions.
struct TransferFunction {
  std::vector<double> numerator, denominator;  ///< coefficients a(i) and b(i)
  double sampling = unset;                     ///< sampling time [s]
};

/// Removes the roots at exactly 1 that numerator and denominator have in common, and returns the
/// reduced transfer function. In exact arithmetic, the common roots cancel. In floating point, the
/// output would drift if these roots were kept, because the response of a pole at 1 never decays.
/// Throws std::invalid_argument if a polynomial is empty, b(0) is not 1, a coefficient is not
/// finite, or the sampling time is not positive.
[[nodiscard]] TransferFunction reduced(const TransferFunction& printed);

/// Returns the result of reduced() with a numerator in um per unit of the input. `unit` is the SI
/// value of the unit of the input. Numerator and denominator of the result have the same length.
/// The coefficients are rounded to 15 digits, so the relative error of the gain is about 1e-9 if
/// the poles are slow. All exported programs use these rounded coefficients, so their results
/// agree.
[[nodiscard]] TransferFunction direct_form(const TransferFunction& printed, double unit);

/// Returns the displacement at every sample of the input, from rest and in double precision. The
/// sampling time of the input must be the sampling time of the transfer function.
[[nodiscard]] std::vector<double> run(const TransferFunction& printed,
                                      std::span<const double> input);
/// Returns the displacement as a controller computes it: in single precision and with the published
/// coefficients, including common roots.
[[nodiscard]] std::vector<float> run_single(const TransferFunction& printed,
                                            std::span<const float> input);

/// Transfer function as the sum of an instant response and of first-order lags x_i. The lags
/// respond to the previous sample of the input u.
///
///   y(k) = through u(k) + sum x_i(k),   x_i(k) = x_i(k-1) + rise_i (gain_i u(k-1) - x_i(k-1))
///
/// Source:   partial fractions of the result of reduced() in z^-1.
/// Domain:   the poles are real, distinct and in the open interval (0, 1). The numerator is not
///           longer than the denominator.
/// Accuracy: limited by the poles, which are computed in extended precision because poles of slow
///           bodies differ by less than 1e-4.
/// Traps:    the lags agree with the transfer function only if they are sampled with the sampling
///           time dt of the transfer function. A lag has the time constant -dt/ln(1 - rise), and
///           its input is constant between samples.
struct ParallelForm {
  struct Lag {
    /// Coefficients of x_i: rise = 1 - pole [1], and gain = final value of x_i per unit of the
    /// input, in the unit of a(0).
    double rise, gain;
  };
  double through = 0.0;  ///< instant response, in the unit of a(0)
  std::vector<Lag> lags{};
};

/// Returns the parallel form of a transfer function. Throws std::invalid_argument if the transfer
/// function is outside the domain of ParallelForm; the message gives the reason.
[[nodiscard]] ParallelForm parallel_form(const TransferFunction& printed);

/// Returns a warning for each kind of pole that no thermal body has: on or outside the unit circle,
/// negative, or complex. The list is empty if there is no such pole.
[[nodiscard]] std::vector<std::string> pole_warnings(const TransferFunction& printed);

/// Returns true if the result of reduced() has a pole on or outside the unit circle.
[[nodiscard]] bool never_decays(const TransferFunction& printed);

/// Results of check() for published coefficients.
struct TransferFunctionCheck {
  /// Poles, including the roots that reduced() removes, the largest first.
  std::vector<std::complex<double>> poles{};
  /// Time constant of each pole [s]; NaN for a complex pole and for a real pole outside 0 to 1,
  /// which have no time constant.
  std::vector<double> time_constants{};
  double dc_gain = unset;  ///< final displacement per unit step, in the unit of a(0)
  /// 5th and 95th percentile of the DC gain in 4000 random draws. A draw varies all coefficients
  /// within the rounding of their last digits. `unstable_share` is the share of draws with a pole
  /// on or outside the unit circle.
  double dc_gain_lower = unset, dc_gain_upper = unset;
  double unstable_share = unset;
  double feedthrough = unset;  ///< a(0): instant displacement per unit step of the input
  /// Error of the step response in single precision after 40 h (at most 2 million samples), divided
  /// by the DC gain [1].
  double single_error = unset;
  std::vector<std::string> warnings{};  ///< warnings, one sentence each
};

/// Checks published coefficients for implausible poles, for the effects of rounding and for steps
/// in the output. `quantum` is the resolution of the sensor, in the unit of the input. `unit` is
/// the unit of the displacement. A warning is added if a step of the input by `quantum` instantly
/// moves the displacement by more than 0.1 `unit`.
[[nodiscard]] TransferFunctionCheck check(const TransferFunction& printed, double quantum = 0.1,
                                          std::string_view unit = "um");

}  // namespace raceway::correction
