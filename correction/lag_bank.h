#pragma once

#include <vector>

#include "correction/identify.h"
#include "correction/series.h"

namespace raceway::correction {

struct LagBankOptions {
  std::vector<const Channel*> inputs{};  ///< columns that drive
  /// Time constants of the lags of every input [s], 0: at once. Empty: usual_lags().
  std::vector<double> time_constants{};
  std::function<void(double share, std::string_view step)> progress{};
  std::function<bool()> cancelled{};  ///< as of IdentifyOptions
};

/// At once, and lags of a hundredth of the longest run and of three times that, up to a quarter of
/// it [s].
[[nodiscard]] std::vector<double> usual_lags(const Series& series);

/// A model of many small shares: every input through the same lags, all gains at once by ridge.
///
///   minimise  mean (y - y0 - sum g_ij x_ij)² + λ sum (w_ij g_ij)²,   w_ij = s_i sqrt(τ_j/5400 s)
///
/// x_ij is input i through lag j, g its gain [um/K, um/(m/min), um/1000 rpm], λ [um² per square of
/// that] the strength, s = 1 but for speeds. Slow lags cost more, since they reach farthest beyond
/// the record; at once counts as 600 s. A speed enters twice, as n and as n (n/1000 rpm)^0.5, by
/// which friction rises, without a share at once. λ from 0.01 to 10 and the s of speeds from 0.1
/// to 1 are tried, each fitted to the record up to six times, from 0.59 to 0.88 of it, and judged
/// by all that comes after; the gains are the mean of all, weighted by that error to the power -4.
/// Parts held out of the middle would favour gains that hold within the record alone, and the best
/// strength alone is chosen by little more than chance.
///
/// With many sensors on unknown bodies, this predicts better than a few sections with their own
/// time constants, which fit equally well but extrapolate badly. It explains nothing. Gains have no
/// standard error, because ridge shrinks them to 0. If the model does not list its free parameters,
/// only the offset is free from then on.
/// Source: ridge regression [HoerlKennard1970]; the bank of lags and its weights are ours, chosen
/// on the record of docs/spindle-record.md.
///
/// Throws std::invalid_argument: a model with channels, a kinematic law, effects or a free initial
/// state; no input; too few readings; a time constant below 0.
[[nodiscard]] Identification identify_lag_bank(const Model& model, const record::Record& record,
                                               const LagBankOptions& options);

}  // namespace raceway::correction
