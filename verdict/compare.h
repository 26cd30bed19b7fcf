#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/noise.h"
#include "fit/subject.h"

namespace raceway::verdict {

/// Error within one range of one input, or of one run; a level of it where the data have few.
struct ErrorRange {
  const record::Channel* channel = nullptr;
  double from = unset, to = unset;  ///< smallest and largest value within [SI]; index of a run
  std::string run{};  ///< run_id, or name of a record or of a group; empty for all else
  int rows = 0;
  double rmse = unset;  ///< SI
  double bias = unset;  ///< mean of prediction minus reading [SI]

  [[nodiscard]] bool is_run() const { return channel->role == record::Role::run; }
};

/// One row, prediction against reading [SI].
struct RowError {
  std::size_t row = 0;  ///< index into the record
  int line = 0;         ///< for people: Record::line()
  double predicted = unset;
  double measured = unset;
  double residual = unset;  ///< prediction minus reading
  double std = unset;       ///< of the reading, NaN where that is not known
  double sigmas = unset;    ///< residual over standard deviation [1]
};

/// Test whether the misfit is larger than the noise.
///   declared or regression   statistic = χ²/degrees of freedom, χ² distribution
///   repeats                  statistic = F, lack of fit over pure error, F distribution
///   none                     NaN
struct LackOfFit {
  double statistic = unset;
  double p_value = unset;
  int degrees_of_freedom = 0;        ///< rows (or groups of repeats) minus fitted parameters
  int noise_degrees_of_freedom = 0;  ///< of the pure error, 0 where the noise is declared
};

/// Correlation of the errors of neighbours in the swept setting; needs no noise. Rows are sorted by
/// run and all other settings, then by the swept one (by time where there is none); correlation =
/// mean product of neighbours over mean square, for pure noise about normal with a variance of
/// 1/pairs. p is one-sided. It also rises where the noise itself drifts along the run.
struct Pattern {
  const record::Channel* along = nullptr;
  double correlation = unset;  ///< in [-1, 1], NaN below 8 pairs
  double p_value = unset;
  int pairs = 0;
};

enum class Judgement {
  structure,  ///< p < 0.01 in the lack-of-fit test, or in the pattern where the noise is unknown
  noise,      ///< the misfit is no larger than the noise
  unknown     ///< the noise is not known, and no pattern shows
};

/// Comparison of a model with the readings of one channel. Residuals are prediction minus reading.
struct Comparison {
  const record::Channel* channel = nullptr;
  int rows = 0;                                                     ///< compared
  double rmse = unset, mae = unset, max_abs = unset, bias = unset;  ///< SI
  /// 100 (1 - |y - ŷ| / |y - mean y|) in Euclidean norms: 100 is perfect, 0 no better than the
  /// mean, negative is worse. NaN if all readings are equal.
  double fit_percent = unset;
  fit::Noise noise{};
  /// Noise that a diagnosis would assume where it is not known [SI]; see estimate_unknown_noise().
  /// NaN if not requested or not determined by the data.
  double estimated_noise = unset;
  LackOfFit lack_of_fit{};
  Pattern pattern{};
  /// Correlation time of the residuals [s]; only for a subject that approximates over time, else
  /// NaN.
  double correlation_time = unset;
  std::string_view begins{};  ///< Measured::begins
  Judgement judgement = Judgement::unknown;
  double tolerance = unset;           ///< acceptable error [SI]; NaN if not given
  std::vector<ErrorRange> where{};    ///< worst first; only of what varies
  std::vector<ErrorRange> records{};  ///< of each of several joined records, in their order
  std::vector<RowError> worst{};      ///< the five worst rows, worst first
  std::vector<RowError> errors{};     ///< all compared rows, in the order of the data
  std::vector<std::size_t> rows_not_predicted{};  ///< but read
  std::string statement{};  ///< in one sentence: how wrong, structure or noise, and where
};

/// Noise of a measured channel: as declared by the model or estimated from neighbours in time if
/// the model only approximates, otherwise estimate_noise().
[[nodiscard]] fit::Noise noise_of(const record::Record& record, const fit::Measured& measured);

/// Compares a model with every measured channel that the record has. `fitted_parameters` of the
/// model were fitted to these very data; they cost degrees of freedom in the test (0 where in
/// doubt, which makes the test milder). Throws std::invalid_argument if nothing can be compared: a
/// record of something else, no row, none predicted.
[[nodiscard]] std::vector<Comparison> compare(const fit::Subject& subject,
                                              const record::Record& record,
                                              int fitted_parameters = 0);

/// Compares one channel with predictions made elsewhere: `predicted` by row of the record, NaN
/// where there is none.
[[nodiscard]] Comparison compare(std::span<const double> predicted, const record::Record& record,
                                 const fit::Measured& measured, int fitted_parameters = 0);

/// Adds groups of rows to `where`: `group` names the group of each row, empty for none; `kind` is a
/// channel of the role of a run that says what they are.
void add_groups(Comparison& comparison, const record::Channel& kind,
                const std::vector<std::string>& group);

/// Fills in Comparison::estimated_noise and the standard deviations of rows where the noise is not
/// known: from a saturated regression, as a diagnosis does. The judgement stays.
void estimate_unknown_noise(const fit::Subject& subject, const record::Record& record,
                            std::vector<Comparison>& comparisons);

/// "p = 0.02"
[[nodiscard]] std::string p_value_text(double p);

}  // namespace raceway::verdict
