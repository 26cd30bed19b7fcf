#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/noise_model.h"
#include "fit/problem.h"
#include "record/note.h"

namespace raceway::verdict {

/// Largest number of rows that diagnose() and add() use. If a record has more rows, these functions
/// choose rows at random. calibrate() always uses all rows.
constexpr int most_rows_of_a_fit = 4000;

/// Model, readings, candidates for missing effects, and noise, prepared for a diagnosis.
struct Evidence {
  fit::Problem problem{};
  fit::Saturation saturation{};
  /// Names of free parameters that change no reading; they are not fitted.
  std::vector<std::string> idle{};
  Eigen::VectorXd size{};                ///< typical size of each reading [SI], from the prediction
  std::vector<fit::NoiseModel> noise{};  ///< noise of each measured channel
  fit::Whitening whitening{};            ///< transformation to readings with independent noise
  /// Transformations like `whitening`, each with another noise model for one channel. Each of these
  /// noise models also agrees with the readings.
  std::vector<fit::Whitening> allowed{};
  double degrees_of_freedom = unset;  ///< degrees of freedom of the noise, summed over the channels
  fit::Response response{};           ///< predicted readings as a function of the free parameters
  fit::ResponseFit base{};  ///< fit of the model without candidates, with the weights from `noise`
  std::size_t rows_in_record = 0;
  /// True if the record has too few rows for an estimate of the noise. The noise then has the
  /// declared standard deviations.
  bool few_rows = false;
  std::string hint{};  ///< warning about a doubtful unit or sign; see fit::Judged::doubt()
  std::vector<record::Note> notes{};

  [[nodiscard]] std::size_t rows() const { return problem.record->rows(); }
  /// Returns the standard deviation of every reading [SI].
  [[nodiscard]] const Eigen::VectorXd& std() const { return whitening.std(); }
};

/// Options of gather_evidence().
struct EvidenceOptions {
  /// Ids of the effects that may be missing; empty means all candidates.
  std::vector<std::string> candidates{};
  int most_rows = most_rows_of_a_fit;
  fit::NoiseOptions noise{};
  bool screened = true;               ///< false if only the noise and the base model are needed
  std::function<bool()> cancelled{};  ///< if this function returns true, fit::Cancelled is thrown
};

/// Checks the data, estimates the noise, and fits the model without candidates. The noise is
/// estimated from a regression of the readings on many smooth functions of the inputs
/// (fit::Saturation) and on the effects of all candidates. The function uses at most `most_rows`
/// rows, chosen at random, or all rows if readings depend on earlier rows. Throws
/// std::invalid_argument if the data cannot give a verdict; the message names the missing
/// measurements or the problem.
[[nodiscard]] Evidence gather_evidence(const fit::Subject& subject, const record::Record& record,
                                       const EvidenceOptions& options = {});

}  // namespace raceway::verdict
