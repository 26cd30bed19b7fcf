#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/model_data.h"
#include "fit/sobol_indices.h"

/// Sensitivity of predictions to the data (numbers) of a model. The name of a datum or prediction
/// ends with its unit, unless the value is dimensionless.
namespace raceway::results {

/// Datum that was varied: a number of the model or of the operating point.
struct VariedDatum {
  std::string name;
  double value = unset;
  double spread = unset;  ///< largest assumed error, upwards or downwards, in the unit of `name`
  /// Origin of `spread`: "given" by the user, "standard error", or the default "1 %", "1 K" or "1"
  /// (for an integer). For a standard error s, the spread is sqrt(3) s. A uniform distribution over
  /// +-sqrt(3) s has the standard deviation s.
  std::string spread_from = {};
  /// Origin of `value`: "file" (model file), "default", "catalogue", or "asked" (a value of the
  /// operating point that the user gives).
  std::string origin = {};
  bool whole = false;          ///< true for an integer, such as the number of balls
  bool has_elasticity = true;  ///< false for a temperature in C, whose zero is arbitrary
};

/// Influence of one datum on one prediction, with all other data fixed.
struct LocalSensitivity {
  double derivative = unset;
  /// Absolute difference between `derivative` and the difference quotient with half the step size.
  double derivative_error = unset;
  double change = unset;  ///< `derivative` times VariedDatum::spread
  /// Predictions at the value of the datum minus its spread, and plus its spread.
  double low = unset, high = unset;
  double share = unset;  ///< `change`² divided by the sum of `change`² over all data [1]
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
  std::size_t state = 0;  ///< index of the operating point in Sensitivity::states
  double value = unset;
  std::vector<LocalSensitivity> local = {};  ///< sensitivity to each datum in Sensitivity::data
  /// Indices in Sensitivity::data, largest |LocalSensitivity::change| first.
  std::vector<std::size_t> order = {};
  /// Sobol' indices of the data in Sensitivity::sampled; empty if not requested.
  std::optional<fit::SobolIndices> global = {};
  /// Sentences for the user. Each sentence names a conclusion for which there are too few samples.
  std::vector<std::string> cannot_tell = {};
};

struct Sensitivity {
  std::string source, model;
  std::vector<std::string> inputs = {};          ///< names of the inputs, such as the speed
  std::vector<std::vector<double>> states = {};  ///< operating points: values of `inputs`
  std::vector<VariedDatum> data = {};            ///< data that affect a prediction
  std::vector<PredictionSensitivity> predictions = {};
  std::vector<std::string> does_not_enter = {};  ///< names of data without any influence
  /// Names of data that could not be varied, each with the reason.
  std::vector<std::pair<std::string, std::string>> not_varied = {};
  std::size_t samples = 0, evaluations = 0;
  std::uint64_t seed = 0;
  std::vector<std::size_t> sampled = {};  ///< indices of the sampled data in `data`
  /// Names of data that were not sampled, each with the error message: the model rejects some
  /// values within the spread of such a datum.
  std::vector<std::pair<std::string, std::string>> not_sampled = {};
  /// Number of evaluations in which at least one prediction failed. For the first of these
  /// evaluations, `why_failed` is the reason, and `first_failed` contains the values of the sampled
  /// data.
  std::size_t failed = 0;
  std::string why_failed = {};
  std::vector<double> first_failed = {};

  [[nodiscard]] bool converged() const;
};

/// Returns the document of `raceway sensitivity --json`.
[[nodiscard]] std::string sensitivity_json(const Sensitivity& s);

}  // namespace raceway::results
