#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/noise_model.h"
#include "fit/problem.h"
#include "record/note.h"

namespace raceway::verdict {

/// A larger record is reduced to this number of randomly chosen rows.
constexpr int most_rows_of_a_fit = 4000;

/// Model, data, candidates and noise, prepared for a diagnosis.
struct Evidence {
  fit::Problem problem{};
  fit::Saturation saturation{};
  /// Free parameters that change no reading; they are not parameters of the base model.
  std::vector<std::string> idle{};
  Eigen::VectorXd size{};                ///< typical size of each reading from the base model
  std::vector<fit::NoiseModel> noise{};  ///< noise of each measured channel
  fit::Whitening whitening{};            ///< weights from the noise of all channels together
  /// Other possible weights. In each of these sets of weights, one channel has another noise shape
  /// that its readings allow.
  std::vector<fit::Whitening> allowed{};
  double degrees_of_freedom = unset;  ///< degrees of freedom of all channels
  fit::Response response{};           ///< response of the base model
  fit::ResponseFit base{};            ///< base model refitted with `noise`
  std::size_t rows_in_record = 0;
  /// True if there are too few rows to determine the noise; the declared noise is then used.
  bool few_rows = false;
  std::string hint{};  ///< likely error in the data (fit::Judged::doubt())
  std::vector<record::Note> notes{};

  [[nodiscard]] std::size_t rows() const { return problem.record->rows(); }
  /// Returns the standard deviation of every reading [SI].
  [[nodiscard]] const Eigen::VectorXd& std() const { return whitening.std(); }
};

/// Options for gathering evidence.
struct EvidenceOptions {
  /// Ids of the effects that may be missing; empty means all candidates.
  std::vector<std::string> candidates{};
  int most_rows = most_rows_of_a_fit;
  fit::NoiseOptions noise{};
  bool screened = true;               ///< false if only the noise and the base model are needed
  std::function<bool()> cancelled{};  ///< returns true to cancel the work; see Problem
};

/// Checks the data, estimates the noise from a saturated regression and refits the base model. The
/// function uses at most `most_rows` rows, chosen at random. Throws std::invalid_argument if the
/// data do not support a verdict; the message says what is needed.
[[nodiscard]] Evidence gather_evidence(const fit::Subject& subject, const record::Record& record,
                                       const EvidenceOptions& options = {});

}  // namespace raceway::verdict
