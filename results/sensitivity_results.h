#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/model_data.h"
#include "fit/sobol_indices.h"

/// Sensitivity of predictions to the data of a model; numbers in the units of their names.
namespace raceway::results {

/// A datum that was varied, or a number of the question.
struct VariedDatum {
  std::string name;
  double value = unset;
  double spread = unset;         ///< how far it may be off, either way
  std::string spread_from = {};  ///< "given", "standard error", "1 %", "1 K", "1"
  std::string origin = {};       ///< "file", "default", "catalogue", "asked"
  bool whole = false;
  bool has_elasticity = true;  ///< not of a temperature in C, whose zero means nothing
};

/// Effect of one datum on one prediction, all others unchanged.
struct LocalSensitivity {
  double derivative = unset;
  double derivative_error = unset;   ///< difference of two steps after extrapolation
  double change = unset;             ///< derivative times spread
  double low = unset, high = unset;  ///< the prediction at value - spread and at value + spread
  double share = unset;              ///< of the sum of squares of the changes [1]
  double elasticity = unset;         ///< percent per percent [1]
  /// The slopes to both sides differ, or the two steps do not agree.
  bool kink = false, steps_disagree = false;
  bool one_sided = false;  ///< the model takes values to one side alone
};

/// One prediction at one state.
struct PredictionSensitivity {
  std::string name;
  std::size_t state = 0;
  double value = unset;
  std::vector<LocalSensitivity> local = {};  ///< of each datum
  std::vector<std::size_t> order = {};       ///< of the data, the largest change first
  /// Sobol' indices of the data in Sensitivity::sampled, if requested.
  std::optional<fit::SobolIndices> global = {};
  std::vector<std::string> cannot_tell = {};  ///< questions that the samples leave open, in words
};

struct Sensitivity {
  std::string source, model;
  std::vector<std::string> inputs = {};          ///< names of the inputs of a state
  std::vector<std::vector<double>> states = {};  ///< values of these
  std::vector<VariedDatum> data = {};            ///< those that enter
  std::vector<PredictionSensitivity> predictions = {};
  std::vector<std::string> does_not_enter = {};
  std::vector<std::pair<std::string, std::string>> not_varied = {};  ///< a datum, and why
  std::size_t samples = 0, evaluations = 0;
  std::uint64_t seed = 0;
  std::vector<std::size_t> sampled = {};  ///< indices of data
  /// Data that the samples leave as they are, since the model does not take all of their spread.
  std::vector<std::pair<std::string, std::string>> not_sampled = {};
  /// Evaluations with a missing prediction, and the data of the first of them.
  std::size_t failed = 0;
  std::string why_failed = {};
  std::vector<double> first_failed = {};

  [[nodiscard]] bool converged() const;
};

/// The document of `raceway sensitivity --json`.
[[nodiscard]] std::string sensitivity_json(const Sensitivity& s);

}  // namespace raceway::results
