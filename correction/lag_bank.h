#pragma once

#include <vector>

#include "correction/identify.h"
#include "correction/series.h"

namespace raceway::correction {

struct LagBankOptions {
  std::vector<const Channel*> inputs{};  ///< columns used as inputs
  /// Time constants of the lags of every input [s]; 0 means an instant response. If the list is
  /// empty, usual_lags() is used.
  std::vector<double> time_constants{};
  std::function<void(double share, std::string_view step)> progress{};
  /// If this function returns true, identify_lag_bank() throws fit::Cancelled.
  std::function<bool()> cancelled{};
};

/// Returns time constants [s]: 0 for an instant response, then values from a hundredth to a quarter
/// of the duration of the longest run. Each value is about three times the previous one.
[[nodiscard]] std::vector<double> usual_lags(const Series& series);

/// Fits a bank of lags: every input drives lags with the same time constants τ_j, and one ridge
/// regression determines all gains.
///
///   minimise  mean (y - y0 - sum g_ij x_ij)² + λ sum (w_ij g_ij)²,   w_ij = s_i sqrt(τ_j/5400 s)
///
///   y     displacement [um]
///   y0    zero (constant offset) of the run [um]
///   x_ij  response of lag j to input i
///   g_ij  gain of x_ij [um/K, um/(m/min) or um/1000 rpm; for other columns, um per tenth of the
///         range of the column]
///   λ     ridge strength [um² per square of the unit of g_ij]
///   s_i   weight of input i in the penalty [1]; only speeds have a weight other than 1
///
/// Slow lags have larger penalties, because their errors decay most slowly after the end of the
/// record. Lags below 600 s and the instant response have the penalty of a lag of 600 s. A speed n
/// adds two inputs: n, and n (n/1000 rpm)^0.5 for the friction heat. A speed has no instant
/// response.
///
/// The program tries seven values of λ (0.01 to 10) and, for the speeds, three weights s_i (0.1 to
/// 1). For each combination, the gains are fitted to six initial parts of the record (59 % to 88 %
/// of its duration) and tested on the rest. The final gains are a weighted mean of the gains that
/// each combination gives for the whole record; the weight is (rms error of the tests)^-4. A mean
/// is used because the choice of a single best λ would depend mostly on chance. The tests use
/// initial parts because tests on parts from the middle of the record would favour gains that are
/// valid only within the record.
///
/// If there are many sensors, and the influence of each sensor on the displacement is unknown, a
/// bank of lags usually predicts better than a few lags with fitted time constants. A few lags fit
/// the record equally well, but extrapolate badly. The gains of a bank have no physical meaning.
/// They also have no standard error, because the ridge penalty shrinks them towards 0. If the model
/// does not list its free parameters, the resulting model lists only the offset as free. A later
/// fit then does not change the gains.
/// Source: ridge regression [HoerlKennard1970]. The time constants, the weights in the penalty and
///         the weights of the fits are our choice, based on the record of docs/spindle-record.md.
///
/// Throws std::invalid_argument for a model with channels, a kinematic law, effects or a free
/// initial state, for an empty list of inputs, for too few readings, and for a time constant that
/// is negative or not finite.
[[nodiscard]] Identification identify_lag_bank(const Model& model, const record::Record& record,
                                               const LagBankOptions& options);

}  // namespace raceway::correction
