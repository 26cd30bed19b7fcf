#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/response.h"

namespace raceway::fit {

/// Thrown out of a search that was told to end.
struct Cancelled : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// A candidate as the data show it.
struct Screened {
  Candidate candidate{};
  bool one_sided = false;  ///< only one sign of the size is physical
  double unit_size = 1.0;  ///< a typical amount of the size, from neutral
  /// Readings per `unit_size`, at the neutral point: one column per trial value of the shapes, not
  /// whitened [SI].
  Eigen::MatrixXd scores{};
  /// Change by the largest amount met in practice, where it is not a multiple of the scores: one
  /// column or none.
  Eigen::MatrixXd most{};
  std::string not_testable{};  ///< why not, in a sentence; empty where it can be tested

  [[nodiscard]] const std::string& id() const { return candidate.id; }
  /// The parameter that gives it its size.
  [[nodiscard]] const Parameter& size() const { return candidate.parameters[candidate.size]; }
};

/// A model, the readings it can predict, and what may be missing.
struct Problem {
  std::shared_ptr<const Subject> subject{};
  std::shared_ptr<const Record> record{};    ///< the rows used, in the one order
  std::vector<std::size_t> rows{};           ///< of the record handed in, by row of this one
  std::vector<std::size_t> not_predicted{};  ///< rows of the record handed in
  Observations observed{};
  std::vector<std::string> base{};     ///< free parameters of the model
  std::vector<Screened> candidates{};  ///< by id, so that their order does not matter
  std::shared_ptr<const void> prepared{};
  /// Asked before each prediction, which throws Cancelled then; may be empty.
  std::function<bool()> cancelled{};

  [[nodiscard]] const Eigen::VectorXd& measured() const { return observed.measured; }
};

/// Readings of the problem's model with some candidates switched on: base parameters first, then
/// the parameters of each candidate.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Screened* const> on);

/// Readings at the rows of another record, with its observations `observed`.
[[nodiscard]] Response response_with(const Problem& problem, std::span<const Screened* const> on,
                                     const std::shared_ptr<const Record>& record,
                                     const Observations& observed);

/// The model of the problem with candidates switched on and the fitted values of `fit`, whose
/// parameters are in the order of response_with().
[[nodiscard]] std::shared_ptr<const Subject> fitted_subject(const Problem& problem,
                                                            std::span<const Screened* const> on,
                                                            const Response& response,
                                                            const Eigen::VectorXd& values);

/// Candidates of these ids (all where empty) with what is known of them before any data.
[[nodiscard]] std::vector<Screened> make_candidates(const Subject& subject,
                                                    std::span<const std::string> ids);

/// Fills in what the candidates need to be screened: scores at the base values `base_values`, and
/// whether they can be tested at all.
void screen_candidates(Problem& problem, const Saturation& saturation,
                       const Eigen::VectorXd& base_values);

}  // namespace raceway::fit
