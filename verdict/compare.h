#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/noise.h"
#include "fit/subject.h"

namespace raceway::verdict {

/// Error within one range of one input, or in one run. If the data have only few levels of the
/// input, each range is one level.
struct ErrorRange {
  const record::Channel* channel = nullptr;
  /// Smallest and largest value in the range [SI], or the index of the run.
  double from = unset, to = unset;
  std::string run{};  ///< run_id, or name of a record or group; empty for ranges of an input
  int rows = 0;
  double rmse = unset;  ///< SI
  double bias = unset;  ///< mean of prediction minus reading [SI]

  [[nodiscard]] bool is_run() const { return channel->role == record::Role::run; }
};

/// Prediction and reading of one row [SI].
struct RowError {
  std::size_t row = 0;  ///< index into the record
  int line = 0;         ///< line number for messages: Record::line()
  double predicted = unset;
  double measured = unset;
  double residual = unset;  ///< prediction minus reading
  double std = unset;       ///< standard deviation of the reading; NaN if unknown
  double sigmas = unset;    ///< residual over standard deviation [1]
};

/// Tests whether the misfit is larger than the noise.
///   declared or regression   statistic = χ²/degrees of freedom, χ² distribution
///   repeats                  statistic = F, lack of fit over pure error, F distribution
///   none                     NaN
struct LackOfFit {
  double statistic = unset;
  double p_value = unset;
  int degrees_of_freedom = 0;  ///< number of rows (repeats count once) minus fitted parameters
  /// Degrees of freedom of the pure error; 0 if the noise is declared.
  int noise_degrees_of_freedom = 0;
};

/// Correlation between the errors of neighbouring rows along the swept input. No estimate of the
/// noise is needed. Rows are sorted by run and all other settings, then by the swept setting (or by
/// time if there is none). The correlation is the mean product of neighbouring errors over their
/// mean square. For pure noise, the correlation is approximately normal with variance 1/pairs. The
/// p-value is one-sided. Noise that drifts along a run also increases the correlation.
struct Pattern {
  const record::Channel* along = nullptr;
  double correlation = unset;  ///< in [-1, 1]; NaN with fewer than 8 pairs
  double p_value = unset;
  int pairs = 0;
};

/// Judgement of a misfit. For a model that only approximates the readings, `structure` means that
/// the error exceeds the tolerance, `noise` that it does not, and `unknown` that no tolerance is
/// given.
enum class Judgement {
  structure,  ///< p < 0.01 in the lack-of-fit test, or in the pattern if the noise is unknown
  noise,      ///< the misfit is no larger than the noise
  unknown     ///< the noise is unknown and the errors show no pattern
};

/// Comparison of a model with the readings of one channel. Residuals are prediction minus reading.
struct Comparison {
  const record::Channel* channel = nullptr;
  int rows = 0;                                                     ///< number of compared rows
  double rmse = unset, mae = unset, max_abs = unset, bias = unset;  ///< SI
  /// 100 (1 - |y - ŷ| / |y - mean y|) in Euclidean norms: 100 is a perfect prediction, 0 is as good
  /// as the mean, and a negative value is worse than the mean. NaN if all readings are equal.
  double fit_percent = unset;
  fit::Noise noise{};
  /// Noise that a diagnosis would assume if the noise is unknown [SI]; see
  /// estimate_unknown_noise(). NaN if not requested, or if the data do not determine the noise.
  double estimated_noise = unset;
  LackOfFit lack_of_fit{};
  Pattern pattern{};
  /// Correlation time of the residuals [s]; NaN except for a model that approximates over time.
  double correlation_time = unset;
  std::string_view begins{};  ///< initial state of the simulation; empty if there is none
  Judgement judgement = Judgement::unknown;
  double tolerance = unset;           ///< acceptable error [SI]; NaN if not given
  std::vector<ErrorRange> where{};    ///< errors by range of each varying input, worst first
  std::vector<ErrorRange> records{};  ///< error of each joined record, in the order of the records
  std::vector<RowError> worst{};      ///< the five worst rows, worst first
  std::vector<RowError> errors{};     ///< all compared rows, in the order of the data
  std::vector<std::size_t> rows_not_predicted{};  ///< rows with a reading but without a prediction
  std::string statement{};  ///< text: size and place of the error, structure or noise
};

/// Returns the noise of a measured channel, by estimate_noise(). For a model that only approximates
/// the readings, the noise is the standard deviation that the model declares. If the model declares
/// no standard deviation, the noise is the scatter of readings that are neighbours in time.
[[nodiscard]] fit::Noise noise_of(const record::Record& record, const fit::Measured& measured);

/// Compares a model with every measured channel of the record. `fitted_parameters` is the number of
/// model parameters that were fitted to these data. Fitted parameters reduce the degrees of freedom
/// of the test. If you do not know the number, use 0, which makes the test less strict. Throws
/// std::invalid_argument if the record does not suit this kind of model, has no rows, or has no row
/// with a prediction.
[[nodiscard]] std::vector<Comparison> compare(const fit::Subject& subject,
                                              const record::Record& record,
                                              int fitted_parameters = 0);

/// Compares one channel with given predictions: `predicted` has one value for each row of the
/// record; NaN marks a missing prediction.
[[nodiscard]] Comparison compare(std::span<const double> predicted, const record::Record& record,
                                 const fit::Measured& measured, int fitted_parameters = 0);

/// Adds the errors of groups of rows to `where`. `group` names the group of each row; an empty name
/// means no group. `kind` is a run channel that describes the groups.
void add_groups(Comparison& comparison, const record::Channel& kind,
                const std::vector<std::string>& group);

/// Fills Comparison::estimated_noise and the standard deviations of rows whose noise is unknown.
/// The values come from a saturated regression, as in a diagnosis. For a model that only
/// approximates the readings, noise_of_calm_readings() gives an upper bound instead. The values do
/// not change the verdict on structure or noise.
void estimate_unknown_noise(const fit::Subject& subject, const record::Record& record,
                            std::vector<Comparison>& comparisons);

/// Returns the text of a p-value: "p = 0.02".
[[nodiscard]] std::string p_value_text(double p);

}  // namespace raceway::verdict
