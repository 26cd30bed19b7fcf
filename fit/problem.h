#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/response.h"

namespace raceway::fit {

/// Exception that ends a calculation after the caller has cancelled it.
struct Cancelled : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// Candidate (an effect that may be missing or a datum that may be wrong) and its influence on the
/// readings. The size of a candidate is the parameter that scales its influence. At the neutral
/// value of the size, the candidate does not change the readings.
struct Screened {
  Candidate candidate{};
  bool one_sided = false;  ///< true if the size can lie on only one side of its neutral value
  double unit_size = 1.0;  ///< typical difference of the size from its neutral value, with sign
  /// Change of the readings if the size differs from its neutral value by `unit_size`, linearised
  /// at the neutral value [SI, not whitened]. The matrix has one column for each tested set of
  /// values of the other parameters of the candidate. Columns in which no reading changes are left
  /// out. If no small size changes a reading, the matrix has one column: the change for the
  /// largest size seen in practice, divided by this size and multiplied by `unit_size`.
  Eigen::MatrixXd scores{};
  /// Change of the readings for the largest size seen in practice [SI]: a matrix with one column.
  /// The matrix has no column if Saturation::proportional is true or if the candidate cannot be
  /// tested.
  Eigen::MatrixXd most{};
  std::string not_testable{};  ///< reason why the candidate cannot be tested; empty if it can

  [[nodiscard]] const std::string& id() const { return candidate.id; }
  /// Returns the parameter that gives the candidate its size.
  [[nodiscard]] const Parameter& size() const { return candidate.parameters[candidate.size]; }
};

/// Model, readings with a prediction, and candidates for missing effects.
struct Problem {
  std::shared_ptr<const Subject> subject{};
  std::shared_ptr<const Record> record{};  ///< rows that are used, in the order of order_of_rows()
  std::vector<std::size_t> rows{};         ///< index of each row in the original record
  /// Indices of rows without a prediction, in the original record.
  std::vector<std::size_t> not_predicted{};
  Observations observed{};
  std::vector<std::string> base{};  ///< names of the free parameters of the model
  /// Candidates, sorted by id.
  std::vector<Screened> candidates{};
  std::shared_ptr<const void> prepared{};  ///< result of Subject::prepare() for `record`
  /// Function that is called before each prediction; may be empty. If the function returns true,
  /// the prediction throws Cancelled.
  std::function<bool()> cancelled{};

  [[nodiscard]] const Eigen::VectorXd& measured() const { return observed.measured; }
};

/// Returns the predicted readings as a function of the parameters, with the candidates `on`
/// switched on. The free parameters of the model come first, then the parameters of each candidate.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Screened* const> on);

/// Returns the predicted readings for the record `record` as a function of the parameters of the
/// overload above. `observed` are the observations of `record`.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Screened* const> on,
                                     const std::shared_ptr<const Record>& record,
                                     const Observations& observed);

/// Returns the model with the candidates `on` switched on and with the parameter values `values`.
/// `response` is the result of response_with() for these candidates.
[[nodiscard]] std::shared_ptr<const Subject> fitted_subject(const Problem& problem,
                                                            std::span<const Screened* const> on,
                                                            const Response& response,
                                                            const Eigen::VectorXd& values);

/// Returns the candidates with these ids, sorted by id; all candidates if `ids` is empty. The
/// members `scores`, `most` and `not_testable` are empty until screen_candidates() calculates them.
[[nodiscard]] std::vector<Screened> make_candidates(const Subject& subject,
                                                    std::span<const std::string> ids);

/// Calculates the members of Screened that make_candidates() leaves empty. `base_values` are the
/// values of the free parameters of the model.
void screen_candidates(Problem& problem, const Saturation& saturation,
                       const Eigen::VectorXd& base_values);

}  // namespace raceway::fit
