#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/response.h"

namespace raceway::fit {

/// Exception of a search that the caller cancelled.
struct Cancelled : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// A candidate with its effect on the data.
struct Screened {
  Candidate candidate{};
  bool one_sided = false;  ///< true if only one sign of the size is physical
  double unit_size = 1.0;  ///< typical change of the size from its neutral value
  /// Change of the readings per `unit_size` at the neutral point [SI, not whitened]; one column for
  /// each trial value of the shape parameters.
  Eigen::MatrixXd scores{};
  /// Change of the readings for the largest size seen in practice. The matrix has one
  /// column, or none if this change is a multiple of the scores.
  Eigen::MatrixXd most{};
  std::string not_testable{};  ///< reason why the candidate cannot be tested; empty if it can

  [[nodiscard]] const std::string& id() const { return candidate.id; }
  /// Returns the parameter that is the size of the candidate.
  [[nodiscard]] const Parameter& size() const { return candidate.parameters[candidate.size]; }
};

/// A model, the readings that it can predict, and the candidates for missing effects.
struct Problem {
  std::shared_ptr<const Subject> subject{};
  std::shared_ptr<const Record> record{};    ///< rows used, in the standard order
  std::vector<std::size_t> rows{};           ///< index of each row in the original record
  std::vector<std::size_t> not_predicted{};  ///< rows of the original record without a prediction
  Observations observed{};
  std::vector<std::string> base{};  ///< names of the free parameters of the model
  /// Candidates sorted by id, so the order of the caller has no influence.
  std::vector<Screened> candidates{};
  std::shared_ptr<const void> prepared{};
  /// This function is called before each prediction; if it returns true, the prediction throws
  /// Cancelled. May be empty.
  std::function<bool()> cancelled{};

  [[nodiscard]] const Eigen::VectorXd& measured() const { return observed.measured; }
};

/// Returns the response of the model with some candidates switched on. Base parameters come first,
/// then the parameters of each candidate.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Screened* const> on);

/// Returns the response at the rows of another record with the observations `observed`.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Screened* const> on,
                                     const std::shared_ptr<const Record>& record,
                                     const Observations& observed);

/// Returns the model with candidates switched on and with the values of `fit`. The parameters of
/// `fit` are in the order of response_with().
[[nodiscard]] std::shared_ptr<const Subject> fitted_subject(const Problem& problem,
                                                            std::span<const Screened* const> on,
                                                            const Response& response,
                                                            const Eigen::VectorXd& values);

/// Returns the candidates with these ids; all candidates if `ids` is empty. Screened::scores and
/// the other members that need readings are still empty.
[[nodiscard]] std::vector<Screened> make_candidates(const Subject& subject,
                                                    std::span<const std::string> ids);

/// Prepares the screening of the candidates: computes scores at the base values `base_values`, and
/// finds whether each candidate can be tested.
void screen_candidates(Problem& problem, const Saturation& saturation,
                       const Eigen::VectorXd& base_values);

}  // namespace raceway::fit
