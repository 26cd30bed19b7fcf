#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/noise_model.h"
#include "fit/problem.h"
#include "record/note.h"

namespace raceway::verdict {

constexpr int most_rows_of_a_fit = 4000;  ///< of larger records rows are chosen at random

/// Model, data, candidates and noise, made ready to be asked what is missing.
struct Evidence {
  fit::Problem problem{};
  fit::Saturation saturation{};
  std::vector<std::string> idle{};  ///< free parameters that change no reading: not in the base
  Eigen::VectorXd size{};           ///< typical size of each reading, by the base model
  std::vector<fit::NoiseModel> noise{};   ///< of each measured channel
  fit::Whitening whitening{};             ///< of the noise, all channels together
  std::vector<fit::Whitening> allowed{};  ///< other shapes of the noise, of one channel at a time
  double degrees_of_freedom = unset;      ///< of all of them
  fit::Response response{};               ///< of the base model
  fit::ResponseFit base{};                ///< refitted under that noise
  std::size_t rows_in_record = 0;
  bool few_rows = false;  ///< too few to tell their noise, which is the declared one
  std::string hint{};     ///< Judged::doubt()
  std::vector<record::Note> notes{};

  [[nodiscard]] std::size_t rows() const { return problem.record->rows(); }
  /// Standard deviation of every reading [SI].
  [[nodiscard]] const Eigen::VectorXd& std() const { return whitening.std(); }
};

/// Options of a diagnosis.
struct EvidenceOptions {
  /// Effects that may be missing, by id; empty: all candidates.
  std::vector<std::string> candidates{};
  int most_rows = most_rows_of_a_fit;
  fit::NoiseOptions noise{};
  bool screened = true;               ///< false where only the noise and the base are wanted
  std::function<bool()> cancelled{};  ///< see Problem
};

/// Checks the data, estimates the noise from a saturated regression and refits the base model.
/// Uses at most `most_rows` rows, chosen at random.
/// Throws std::invalid_argument where the data cannot carry a verdict, with what is needed.
[[nodiscard]] Evidence gather_evidence(const fit::Subject& subject, const record::Record& record,
                                       const EvidenceOptions& options = {});

}  // namespace raceway::verdict
