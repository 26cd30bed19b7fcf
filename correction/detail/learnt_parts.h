#pragma once

#include <string>
#include <vector>

#include "correction/gauss_markov.h"
#include "correction/learning.h"
#include "correction/series.h"

/// Selects the parts of a model that learning.h learns.
namespace raceway::correction {

/// A quantity of a model that is learned: an unknown with a weight at every row.
struct LearntPart {
  Unknown unknown{};
  std::vector<double> weights{};  ///< contribution that a gain scales [m], or response of a lag [1]
  std::string name{};   ///< name of the contribution that the gain scales, or channel of the lag
  bool is_lag = false;  ///< true for a lag that the model lacks
  double time_constant = unset;  ///< time constant of the lag [s]
  double gain = unset;           ///< factor from the input [SI] to the weight [1] of a lag
};

/// Returns the gains of the contributions of the model, and the lags of its inputs that it lacks.
/// Effects that are valid only for one record (EffectCard::of_reading) have no such gain. Lags are
/// added only to channels with sections and a known input range.
[[nodiscard]] std::vector<LearntPart> learnt_parts(const Model& model, const Series& series,
                                                   const LearningOptions& options, double misfit);

/// Returns the unknowns for the zero, for the rate of the zero, and for the residual of the model,
/// with one process for each memory (see learning.h).
[[nodiscard]] std::vector<Unknown> zero_and_misfits(const Model& model, double misfit);

/// Returns the model with the learned zero and parts.
[[nodiscard]] Model with_learnt(const Model& model, const std::vector<LearntPart>& parts,
                                const std::vector<double>& values, double zero, double misfit);

}  // namespace raceway::correction
