#pragma once

#include <string>
#include <vector>

#include "correction/gauss_markov.h"
#include "correction/learning.h"
#include "correction/series.h"

/// Part of learning.h: what of a model is learnt.
namespace raceway::correction {

/// A number of a model that is learnt, as an unknown with its weight at every row.
struct LearntPart {
  Unknown unknown{};
  std::vector<double> weights{};  ///< of a gain: the contribution [m]; of a lag [1]
  std::string name{};            ///< of the contribution that it makes larger; of a lag the channel
  bool is_lag = false;           ///< one that the model lacks
  double time_constant = unset;  ///< of the lag [s]
  double gain = unset;           ///< of the lag where the unknown is 1 [1] per SI unit of the input
};

/// Gains of all that the model adds up, and lags of its inputs that it lacks; these only of
/// channels that have sections and of whose inputs the model knows the range.
[[nodiscard]] std::vector<LearntPart> learnt_parts(const Model& model, const Series& series,
                                                   const LearningOptions& options, double misfit);

/// The zero, its rate, and what the model leaves by its memories.
[[nodiscard]] std::vector<Unknown> zero_and_misfits(const Model& model, double misfit);

/// The model with its zero and its parts as they were found.
[[nodiscard]] Model with_learnt(const Model& model, const std::vector<LearntPart>& parts,
                                const std::vector<double>& values, double zero, double misfit);

}  // namespace raceway::correction
