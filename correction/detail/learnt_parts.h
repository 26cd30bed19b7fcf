#pragma once

#include <string>
#include <vector>

#include "correction/gauss_markov.h"
#include "correction/learning.h"
#include "correction/series.h"

/// Selects the gains of a model that learn() adapts.
namespace raceway::correction {

/// A gain that learn() adapts: an unknown with a weight at every row.
struct LearntPart {
  Unknown unknown{};
  /// Contribution that the gain scales [m], or response of a lag [1].
  std::vector<double> weights{};
  std::string name{};   ///< name of the contribution that the gain scales, or channel of the lag
  bool is_lag = false;  ///< true: an additional lag that the model lacks
  double time_constant = unset;  ///< time constant of the lag [s]
  /// For a lag: ratio of `weights` to the response of the lag [1 over the SI unit of its input].
  double gain = unset;
};

/// Returns the gains of all contributions of the model and of additional lags. Effects that are
/// valid only for one record (EffectCard::of_reading) are left out. Only channels with lags and a
/// known input range have additional lags. `misfit` is the expected residual [m].
[[nodiscard]] std::vector<LearntPart> learnt_parts(const Model& model, const Series& series,
                                                   const LearningOptions& options, double misfit);

/// Returns the unknowns for the zero, for its rate of change, and for the residual of the model,
/// with one process for each correlation time (see learning.h).
[[nodiscard]] std::vector<Unknown> zero_and_misfits(const Model& model, double misfit);

/// Returns the model with the learned zero [m] and gains. `values` are in the order of `parts`.
[[nodiscard]] Model with_learnt(const Model& model, const std::vector<LearntPart>& parts,
                                const std::vector<double>& values, double zero, double misfit);

}  // namespace raceway::correction
