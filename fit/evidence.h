#pragma once

#include <span>

#include "fit/candidates.h"
#include "fit/noise_model.h"

namespace raceway::fit {

constexpr int most_rows_of_a_fit = 4000;  ///< of larger data sets every k-th row is used

/// Model, data, candidates and noise, made ready to be asked what is missing.
struct Evidence {
  Problem problem;
  std::vector<std::string> idle{};  ///< free parameters that change no reading: not in the base
  Eigen::VectorXd size{};           ///< typical size of each reading, by the base model
  NoiseModel noise{};
  Response response{};  ///< of the base model
  ResponseFit base{};   ///< refitted under that noise
  int rows_in_file = 0;
  std::string hint{};  ///< where the readings look like another unit or the other sign
};

/// Checks the data, estimates the noise from a saturated regression and refits the base model.
/// Of more than `most_rows` rows every k-th is used.
/// Throws std::invalid_argument where the data cannot carry a verdict, with what is needed.
[[nodiscard]] Evidence gather_evidence(const Model& model, const DataSet& data,
                                       std::span<const effects::Description* const> candidates,
                                       int most_rows, const NoiseOptions& options = {});

}  // namespace raceway::fit
