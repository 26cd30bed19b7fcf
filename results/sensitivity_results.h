#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/model_data.h"
#include "fit/sobol_indices.h"

/// Sensitivity of predictions to the numbers (data) of a model. A member `name` ends with the unit
/// of the datum or prediction, unless it is dimensionless.
namespace raceway::results {

/// Datum that was varied: a number of the model or of the operating point.
struct VariedDatum {
  std::string name;
  double value = unset;
  double spread = unset;  ///< possible error in both directions, in the unit of `name`
  /// Origin of `spread`: "given", "standard error" (√3 standard errors), "1 %", "1 K" or "1".
  std::string spread_from = {};
  /// Origin of `value`: "file", "default", "catalogue", or "asked" for the operating point.
  std::string origin = {};
  bool whole = false;
  bool has_elasticity = true;  ///< false for a temperature in C, whose zero is arbitrary
};

/// Influence of one datum on one prediction, with all other data fixed.
struct LocalSensitivity {
  double derivative = unset;
  double derivative_error = unset;   ///< |derivative - difference quotient with half the step|
  double change = unset;             ///< derivative times spread
  double low = unset, high = unset;  ///< predictions at value - spread and at value + spread
  double share = unset;              ///< `change` squared / sum of squared changes of all data [1]
  /// Relative change of the prediction per relative change of the datum [1].
  double elasticity = unset;
  /// `kink` is true if the slopes below and above the value differ. `steps_disagree` is true if the
  /// finite difference step and half of this step give different slopes.
  bool kink = false, steps_disagree = false;
  bool one_sided = false;  ///< true if predictions exist on only one side of the value
};

/// Sensitivity of one prediction at one operating point.
struct PredictionSensitivity {
  std::string name;
  std::size_t state = 0;
  double value = unset;
  std::vector<LocalSensitivity> local = {};  ///< sensitivity to each datum in Sensitivity::data
  std::vector<std::size_t> order = {};  ///< indices into Sensitivity::data, largest |change| first
  /// Sobol' indices of the data in Sensitivity::sampled; empty if not requested.
  std::optional<fit::SobolIndices> global = {};
  /// Sentences about conclusions that the samples do not permit.
  std::vector<std::string> cannot_tell = {};
};

struct Sensitivity {
  std::string source, model;
  std::vector<std::string> inputs = {};          ///< names of the inputs, such as the speed
  std::vector<std::vector<double>> states = {};  ///< operating points: values of `inputs`
  std::vector<VariedDatum> data = {};            ///< data that affect a prediction
  std::vector<PredictionSensitivity> predictions = {};
  std::vector<std::string> does_not_enter = {};
  /// Names of data that could not be varied, each with the reason.
  std::vector<std::pair<std::string, std::string>> not_varied = {};
  std::size_t samples = 0, evaluations = 0;
  std::uint64_t seed = 0;
  std::vector<std::size_t> sampled = {};  ///< indices of the sampled data in `data`
  /// Names of data that were not sampled because the model rejects part of their spread, each with
  /// the message of the model.
  std::vector<std::pair<std::string, std::string>> not_sampled = {};
  /// Number of evaluations that do not give all predictions. For the first of these evaluations,
  /// `why_failed` is the reason and `first_failed` contains the values of the sampled data.
  std::size_t failed = 0;
  std::string why_failed = {};
  std::vector<double> first_failed = {};

  [[nodiscard]] bool converged() const;
};

/// Returns the document of `raceway sensitivity --json`.
[[nodiscard]] std::string sensitivity_json(const Sensitivity& s);

}  // namespace raceway::results
