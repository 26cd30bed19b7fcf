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
/// on the additional columns in `offered`. In the result, each input drives a channel with a
/// feedthrough (instant response) and without lags. The regression predicts each row from the
/// inputs of this row only, and extrapolates linearly. Three kinds of inputs are left out:
/// calculated powers, inputs that never vary, and inputs that depend linearly on other inputs. A
/// message names each omitted input. The standard errors take the autocorrelation of the residual
/// into account. For the held-out error, the record is divided into eight parts. Each part is
/// predicted with coefficients that are fitted to the other seven parts.
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

/// Returns channels with the names and inputs of the channels of a model, but without lags. A
/// regression or an ARX model is fitted with these channels. A channel whose input is a calculated
/// power (Input::is_power()) is left out, and a message says so. Each column in `offered` that is
/// not the input of one of these channels gives a further channel. Throws std::invalid_argument if
/// the result would be empty.
[[nodiscard]] std::vector<DrivenChannel> bare_channels(const Model& model,
                                                       const std::vector<const Channel*>& offered,
                                                       std::vector<record::Note>& messages);

/// ARX model: predicts the reading y at step k from earlier readings and from the inputs u_j.
///
///   y(k) = sum_i a_i y(k-i) + sum_ij b_ij u_j(k-i) + c
///
/// n is the order of the model: i runs from 1 to n for the readings y, and from 0 to n for the
/// inputs u_j. c is a constant.
/// Source:   least squares of the one-step prediction (Ljung, System Identification, 2nd ed. 1999,
///           sec. 4.2).
/// Traps:    a one-step prediction starts from measured values, so its error is small even with
///           wrong poles. If readings are close in time or have a coarse resolution, a small error
///           only means that the next reading is nearly equal to the last one. A machine control
///           has no readings of the displacement, so the model in the control must be accurate in a
///           simulation without readings. Noise of the readings moves the estimated poles towards
///           0.
struct ArxFit {
  int order = 0;
  Metrics one_step{}, simulated{};
  /// Errors of a simulation of the second half of the record, with coefficients fitted to the first
  /// half.
  Metrics second_half{};
  std::vector<std::complex<double>> poles{};  ///< poles in the z plane, largest magnitude first
  /// Time constant of each pole [s]; NaN for a complex pole, and for a real pole that is not
  /// between 0 and 1.
  std::vector<double> time_constants{};
  bool stable = false;
  /// One channel for each input, with a transfer function. All transfer functions have the same
  /// denominator.
  std::vector<DrivenChannel> channels{};
  double offset = 0.0;  ///< displacement for zero inputs [m]
};

struct ArxBaseline {
  double sampling = unset;  ///< time step of the uniform grid on which the models are fitted [s]
  std::size_t rows = 0;
  std::vector<std::string> inputs{};
  std::vector<ArxFit> fits{};  ///< one fit for each order, in rising order
  std::vector<record::Note> messages{};

  /// Returns the stable fit with the smallest rms error in `second_half`. The result is null if
  /// there is no stable fit with a finite rms error.
  [[nodiscard]] const ArxFit* best() const;
};

/// Returns a model whose channels are the transfer functions of `fit`. The model is valid only for
/// records with the sampling interval of `baseline`.
[[nodiscard]] Model with_arx(const Model& model, const ArxBaseline& baseline, const ArxFit& fit);

/// Fits ARX models of the orders `lowest` to `highest` on a uniform time grid. The step of the grid
/// is the median interval between readings. Throws std::invalid_argument if there is no input, or
/// if there are too few readings for the coefficients.
[[nodiscard]] ArxBaseline arx_baseline(const Model& model,
                                       const std::vector<const Channel*>& offered,
                                       const record::Record& record, int lowest, int highest);

}  // namespace raceway::correction
