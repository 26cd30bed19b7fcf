#pragma once

#include <complex>
#include <string>
#include <vector>

#include "correction/identify.h"
#include "correction/metrics.h"
#include "correction/model.h"
#include "record/record.h"

/// Fits simple models for comparison. A useful correction must be better than these models.
namespace raceway::correction {

/// Fits a multiple linear regression on the inputs of the model's channels and on further columns.
/// Each input becomes a channel with only a feedthrough, so the result runs like every other model.
/// The model has no memory and extrapolates linearly. The fit leaves out channels driven by a
/// power, inputs that never vary, and inputs that depend linearly on other inputs. A message names
/// each input that is left out. Standard errors are widened for the autocorrelation of the
/// residual. The held-out error comes from eight parts of the record. Each of these parts is
/// predicted with coefficients that are fitted to the other seven.
///
/// Throws std::invalid_argument if no input varies or there are too few readings.
/// Source:   least squares by QR decomposition, see regression.h.
[[nodiscard]] Identification regression_baseline(const Model& model,
                                                 const std::vector<const Channel*>& offered,
                                                 const record::Record& record);

/// Returns true if a model consists only of instant channels driven by columns, as a linear
/// regression does.
[[nodiscard]] bool is_regression(const Model& model);

/// Returns the channels of a model that a regression or an ARX model can use, without their
/// sections. Channels driven by a power are left out. The result also has one channel for each
/// further column. Throws std::invalid_argument if there are no such channels.
[[nodiscard]] std::vector<DrivenChannel> bare_channels(const Model& model,
                                                       const std::vector<const Channel*>& offered,
                                                       std::vector<record::Note>& messages);

/// ARX model: predicts a reading from earlier readings and inputs.
///
///   y(k) = sum_i a_i y(k-i) + sum_ij b_ij u_j(k-i) + c,   i = 1..n of y, 0..n of u
///
/// Source:   least squares of the one-step prediction [Ljung1999, sec. 4.2].
/// Traps:    each step starts from readings, so even wrong poles give a good one-step fit. If
///           readings are close in time or have a coarse resolution, a good fit only means that the
///           next reading is similar to the last one. A control uses the simulation, which has no
///           readings. Noise of the readings moves the estimated poles towards 0.
struct ArxFit {
  int order = 0;
  Metrics one_step{}, simulated{};
  /// Errors over the second half of the record, simulated with the fit to the first half.
  Metrics second_half{};
  std::vector<std::complex<double>> poles{};  ///< poles in z, the largest first
  /// Time constant of each pole [s]; NaN unless the pole is real and between 0 and 1.
  std::vector<double> time_constants{};
  bool stable = false;
  /// Channels as transfer functions, one for each input, with a common denominator.
  std::vector<DrivenChannel> channels{};
  double offset = 0.0;  ///< displacement for zero inputs: first reading + fitted constant [m]
};

struct ArxBaseline {
  double sampling = unset;  ///< time step of the even grid over the record [s]
  std::size_t rows = 0;
  std::vector<std::string> inputs{};
  std::vector<ArxFit> fits{};  ///< one fit for each order, in rising order
  std::vector<record::Note> messages{};

  /// Returns the stable order with the smallest error over the second half, simulated with the fit
  /// to the first half; null if no order is stable.
  [[nodiscard]] const ArxFit* best() const;
};

/// Returns a model whose channels are the transfer functions of `fit`. This model is valid only for
/// the sampling interval of the baseline.
[[nodiscard]] Model with_arx(const Model& model, const ArxBaseline& baseline, const ArxFit& fit);

/// Fits ARX models of the orders `lowest` to `highest` on an even time grid. The step of the grid
/// is the median interval between readings. Throws std::invalid_argument if there is no input or
/// there are too few readings.
[[nodiscard]] ArxBaseline arx_baseline(const Model& model,
                                       const std::vector<const Channel*>& offered,
                                       const record::Record& record, int lowest, int highest);

}  // namespace raceway::correction
