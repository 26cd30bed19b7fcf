#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/response.h"

namespace raceway::fit {

/// Exception that ends a calculation which the caller has cancelled.
struct Cancelled : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// Candidate, and its influence on the readings.
struct Screened {
  Candidate candidate{};
  bool one_sided = false;  ///< true if the size can lie on one side of its neutral value only
  double unit_size = 1.0;  ///< typical signed difference of the size from its neutral value
  /// Change of the readings if the size differs from its neutral value by `unit_size`, linearised
  /// at the neutral value [SI, not whitened]. The matrix has one column for each tested set of
  /// values of the other parameters of the candidate. Columns without a change are left out. If no
  /// small size changes a reading, the change for the largest size seen in practice is scaled to
  /// `unit_size`.
  Eigen::MatrixXd scores{};
  /// Change of the readings for the largest size seen in practice [SI]. The matrix has one column,
  /// or none if Saturation::proportional is true.
  Eigen::MatrixXd most{};
  std::string not_testable{};  ///< reason why the candidate cannot be tested; empty if it can

  [[nodiscard]] const std::string& id() const { return candidate.id; }
  /// Returns the parameter that gives the candidate its size.
  [[nodiscard]] const Parameter& size() const { return candidate.parameters[candidate.size]; }
};

/// Model, readings that it can predict, and candidates for missing effects.
struct Problem {
  std::shared_ptr<const Subject> subject{};
  std::shared_ptr<const Record> record{};  ///< rows that are used, in the order of order_of_rows()
  std::vector<std::size_t> rows{};         ///< index of each row in the original record
  /// Indices of rows without a prediction, in the original record.
  std::vector<std::size_t> not_predicted{};
  Observations observed{};
  std::vector<std::string> base{};  ///< names of the free parameters of the model
  /// Candidates sorted by id, so that the order in which a caller names them has no influence.
  std::vector<Screened> candidates{};
  std::shared_ptr<const void> prepared{};
  /// Function that is called before each prediction. If it returns true, the prediction throws
  /// Cancelled. The function may be empty.
  std::function<bool()> cancelled{};

  [[nodiscard]] const Eigen::VectorXd& measured() const { return observed.measured; }
};

/// Returns the readings as a function of the parameters, with the candidates `on` switched on. The
/// free parameters of the model come first, then the parameters of each candidate.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Screened* const> on);

/// Works like the function above, for the observations `observed` of another record.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Screened* const> on,
                                     const std::shared_ptr<const Record>& record,
                                     const Observations& observed);

/// Returns the model with the candidates `on` and with these parameter values. `response` is the
/// result of response_with() for these candidates.
[[nodiscard]] std::shared_ptr<const Subject> fitted_subject(const Problem& problem,
                                                            std::span<const Screened* const> on,
                                                            const Response& response,
                                                            const Eigen::VectorXd& values);

/// Returns the candidates with these ids, sorted by id; all candidates if `ids` is empty. Members
/// that need readings, such as Screened::scores, are still empty.
[[nodiscard]] std::vector<Screened> make_candidates(const Subject& subject,
                                                    std::span<const std::string> ids);

/// Calculates the members `scores`, `most` and `not_testable` of all candidates. `base_values` are
/// the values of the free parameters of the model.
void screen_candidates(Problem& problem, const Saturation& saturation,
                       const Eigen::VectorXd& base_values);

}  // namespace raceway::fit
