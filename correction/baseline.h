#pragma once

#include <complex>
#include <string>
#include <vector>

#include "correction/identify.h"
#include "correction/metrics.h"
#include "correction/model.h"
#include "record/record.h"

/// Models that others have to beat, or that show why they are not used.
namespace raceway::correction {

/// Multiple linear regression on the inputs of the channels of a model and on further columns. Each
/// is a channel with a feedthrough alone, so that the result runs wherever models run. It has no
/// memory and extrapolates linearly. Power is left out, with a message; so are inputs that never
/// vary or follow from the others.
///
/// Source:   least squares by QR, see regression.h; standard errors are widened for the
///           autocorrelation of the residual. Held out: eight parts, each by the coefficients of
///           the others.
/// Throws std::invalid_argument: no input, too few readings.
[[nodiscard]] Identification regression_baseline(const Model& model,
                                                 const std::vector<const Channel*>& offered,
                                                 const record::Record& record);

/// True for a model that is nothing but a regression.
[[nodiscard]] bool is_regression(const Model& model);

/// The channels of a model that such baselines can have, without sections, and one for each further
/// column. Throws std::invalid_argument where there is none.
[[nodiscard]] std::vector<DrivenChannel> bare_channels(const Model& model,
                                                       const std::vector<const Channel*>& offered,
                                                       std::vector<record::Note>& messages);

/// An ARX model: a reading from the readings and inputs before it.
///
///   y(k) = sum_i a_i y(k-i) + sum_ij b_ij u_j(k-i) + c,   i = 1..n of y, 0..n of u
///
/// Source:   least squares of the one-step prediction [Ljung1999, sec. 4.2].
/// Traps:    each step begins at readings, so that the fit is good whatever the poles are: with
///           readings that are close to each other or coarse it says little more than that the
///           next one is like the last. What a control gets is the simulation, which never sees a
///           reading. Noise of a reading pulls the poles towards 0.
struct ArxFit {
  int order = 0;
  Metrics one_step{}, simulated{};
  /// Errors over the second half, simulated by the fit of the first half.
  Metrics second_half{};
  std::vector<std::complex<double>> poles{};  ///< of z, the largest first
  std::vector<double> time_constants{};       ///< of each [s]; NaN for one that is no decay
  bool stable = false;
  /// The channels as transfer functions, one for each input, all with one denominator.
  std::vector<DrivenChannel> channels{};
  double offset =
      0.0;  ///< what the constant of the equation settles at, above the first reading [m]
};

struct ArxBaseline {
  double sampling = unset;  ///< [s], of an even grid over the record
  std::size_t rows = 0;
  std::vector<std::string> inputs{};
  std::vector<ArxFit> fits{};  ///< by order
  std::vector<record::Note> messages{};

  /// The stable order that errs least over the second half, simulated by the fit of the first; null
  /// where none is stable.
  [[nodiscard]] const ArxFit* best() const;
};

/// The model as transfer functions of an order, for calls at the sampling of the baseline.
[[nodiscard]] Model with_arx(const Model& model, const ArxBaseline& baseline, const ArxFit& fit);

/// Fits on an even grid as fine as the readings come. Throws std::invalid_argument: no input, too
/// few readings.
[[nodiscard]] ArxBaseline arx_baseline(const Model& model,
                                       const std::vector<const Channel*>& offered,
                                       const record::Record& record, int lowest, int highest);

}  // namespace raceway::correction
