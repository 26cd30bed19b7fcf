#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/model_data.h"
#include "fit/sobol_indices.h"

/// Sensitivity of predictions to the data of a model. Values have the units in their names.
namespace raceway::results {

/// A datum of the model or of the question that was varied.
struct VariedDatum {
  std::string name;
  double value = unset;
  double spread = unset;  ///< possible error in either direction
  /// Origin of `spread`: "given", "standard error", "1 %", "1 K" or "1".
  std::string spread_from = {};
  std::string origin = {};  ///< origin of `value`: "file", "default", "catalogue" or "asked"
  bool whole = false;
  bool has_elasticity = true;  ///< false for a temperature in C, whose zero is arbitrary
};

/// Influence of one datum on one prediction with all other data fixed.
struct LocalSensitivity {
  double derivative = unset;
  double derivative_error = unset;   ///< |derivative - difference quotient with step h/2|
  double change = unset;             ///< derivative times spread
  double low = unset, high = unset;  ///< predictions at value - spread and at value + spread
  double share = unset;              ///< share of the sum of squared changes [1]
  double elasticity = unset;         ///< change in percent per percent [1]
  /// `kink` means that the slopes on the two sides of the value differ. `steps_disagree` means that
  /// the steps h and h/2 give different slopes.
  bool kink = false, steps_disagree = false;
  bool one_sided = false;  ///< true if the model accepts values on one side only
};

/// Sensitivity of one prediction at one state.
struct PredictionSensitivity {
  std::string name;
  std::size_t state = 0;
  double value = unset;
  std::vector<LocalSensitivity> local = {};  ///< sensitivity to each datum
  std::vector<std::size_t> order = {};       ///< indices of the data, largest change first
  /// Sobol' indices of the data in Sensitivity::sampled, if requested.
  std::optional<fit::SobolIndices> global = {};
  /// statements on questions that the samples cannot answer
  std::vector<std::string> cannot_tell = {};
};

struct Sensitivity {
  std::string source, model;
  std::vector<std::string> inputs = {};          ///< names of the inputs of a state
  std::vector<std::vector<double>> states = {};  ///< values of `inputs` at each state
  std::vector<VariedDatum> data = {};            ///< data that affect a prediction
  std::vector<PredictionSensitivity> predictions = {};
  std::vector<std::string> does_not_enter = {};
  std::vector<std::pair<std::string, std::string>> not_varied = {};  ///< each datum with the reason
  std::size_t samples = 0, evaluations = 0;
  std::uint64_t seed = 0;
  std::vector<std::size_t> sampled = {};  ///< indices of the sampled data
  /// Data that are not sampled, each with the reason: the model rejects part of the spread.
  std::vector<std::pair<std::string, std::string>> not_sampled = {};
  /// Number of evaluations with a missing prediction, and the data of the first such evaluation.
  std::size_t failed = 0;
  std::string why_failed = {};
  std::vector<double> first_failed = {};

  [[nodiscard]] bool converged() const;
};

/// Returns the document of `raceway sensitivity --json`.
[[nodiscard]] std::string sensitivity_json(const Sensitivity& s);

}  // namespace raceway::results
