#pragma once

#include <complex>
#include <string>
#include <vector>

#include "correction/identify.h"
#include "correction/metrics.h"
#include "correction/model.h"
#include "record/record.h"

/// Fits simple models for comparison with a correction. A useful correction has a smaller error
/// than these models.
namespace raceway::correction {

/// Fits a multiple linear regression of the displacement on the inputs of the model's channels and
/// on the columns `offered`. Each input becomes a channel with only a feedthrough, so the result is
/// simulated like every other model. The regression has no memory and extrapolates linearly. The
/// fit leaves out channels driven by a power, inputs that never vary, and inputs that depend
/// linearly on other inputs. A message names each omitted input. The standard errors include the
/// autocorrelation of the residual. For the held-out error, eight parts of the record are each
/// predicted with coefficients that are fitted to the other seven.
///
/// Throws std::invalid_argument if no input varies, or if there are fewer than three readings per
/// coefficient.
/// Source:   least squares by QR decomposition, see regression.h.
[[nodiscard]] Identification regression_baseline(const Model& model,
                                                 const std::vector<const Channel*>& offered,
                                                 const record::Record& record);

/// Returns true if a model has only channels that respond to columns instantly, as in a linear
/// regression, and no kinematic law or effect.
[[nodiscard]] bool is_regression(const Model& model);

/// Returns the channels of a model without their sections, for a regression or an ARX model.
/// Channels driven by a power are left out, with a message. Each column in `offered` that does not
/// drive a channel yet adds one channel. Throws std::invalid_argument if the result would be empty.
[[nodiscard]] std::vector<DrivenChannel> bare_channels(const Model& model,
                                                       const std::vector<const Channel*>& offered,
                                                       std::vector<record::Note>& messages);

/// ARX model: predicts the reading y at step k from earlier readings and from the inputs u_j.
///
///   y(k) = sum_i a_i y(k-i) + sum_ij b_ij u_j(k-i) + c
///
/// i is 1 to n for the readings y, and 0 to n for the inputs u_j, with the order n.
/// Source:   least squares of the one-step prediction (Ljung, System Identification, 2nd ed. 1999,
///           sec. 4.2).
/// Traps:    a one-step prediction starts from readings, so it is good even with wrong poles. If
///           readings are close in time or have a coarse resolution, a good one-step prediction
///           only means that the next reading resembles the last one. A control has no readings and
///           needs a model that is good in simulation. Noise of the readings moves the estimated
///           poles towards 0.
struct ArxFit {
  int order = 0;
  Metrics one_step{}, simulated{};
  /// Errors of a simulation of the second half of the record, with coefficients fitted to the first
  /// half.
  Metrics second_half{};
  std::vector<std::complex<double>> poles{};  ///< poles in z, the largest first
  /// Time constant of each pole [s]; NaN unless the pole is real and between 0 and 1.
  std::vector<double> time_constants{};
  bool stable = false;
  /// One channel for each input, with a transfer function. All transfer functions have the same
  /// denominator.
  std::vector<DrivenChannel> channels{};
  double offset = 0.0;  ///< displacement for zero inputs [m]
};

struct ArxBaseline {
  double sampling = unset;  ///< time step of the even grid over the record [s]
  std::size_t rows = 0;
  std::vector<std::string> inputs{};
  std::vector<ArxFit> fits{};  ///< one fit for each order, in rising order
  std::vector<record::Note> messages{};

  /// Returns the stable fit with the smallest rms in `second_half`; null if no stable fit has a
  /// finite rms in `second_half`.
  [[nodiscard]] const ArxFit* best() const;
};

/// Returns a model whose channels are the transfer functions of `fit`. The model is valid only for
/// records with the sampling interval of `baseline`.
[[nodiscard]] Model with_arx(const Model& model, const ArxBaseline& baseline, const ArxFit& fit);

/// Fits ARX models of the orders `lowest` to `highest` on an even time grid. The step of the grid
/// is the median interval between readings. Throws std::invalid_argument if there is no input, or
/// if there are too few readings for the coefficients.
[[nodiscard]] ArxBaseline arx_baseline(const Model& model,
                                       const std::vector<const Channel*>& offered,
                                       const record::Record& record, int lowest, int highest);

}  // namespace raceway::correction
