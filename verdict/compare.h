#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/noise.h"
#include "fit/subject.h"

namespace raceway::verdict {

/// Errors in one range of one input, or in one run. If the input has few levels in the data, each
/// range is one level.
struct ErrorRange {
  const record::Channel* channel = nullptr;
  /// Smallest and largest value of the input in the range [SI]; for a run, its index.
  double from = unset, to = unset;
  std::string run{};  ///< run_id, or name of a record or group; empty for ranges of an input
  int rows = 0;
  double rmse = unset;  ///< RMS error [SI]
  double bias = unset;  ///< mean of prediction minus reading [SI]

  [[nodiscard]] bool is_run() const { return channel->role == record::Role::run; }
};

/// Prediction and reading of one row [SI].
struct RowError {
  std::size_t row = 0;  ///< row index in the record
  int line = 0;         ///< line number for messages: Record::line()
  double predicted = unset;
  double measured = unset;
  double residual = unset;  ///< prediction minus reading
  double std = unset;       ///< standard deviation of the reading; NaN if unknown
  double sigmas = unset;    ///< `residual` divided by `std` [1]
};

/// Result of the test whether the misfit is larger than the noise. The source of the noise
/// (NoiseSource) determines the test:
///   declared or regression   statistic = χ²/degrees of freedom, χ² distribution
///   repeats                  statistic = F, lack of fit over pure error, F distribution
///   none                     NaN
/// For a model that only approximates the readings, the test is not carried out: NaN.
struct LackOfFit {
  double statistic = unset;
  double p_value = unset;
  /// Number of rows minus number of fitted parameters. If the noise comes from repeats, a group of
  /// repeated rows counts as one row.
  int degrees_of_freedom = 0;
  /// Degrees of freedom of the scatter within repeats (pure error); 0 if the noise does not come
  /// from repeats.
  int noise_degrees_of_freedom = 0;
};

/// Correlation between the residuals of neighbouring rows along the swept input, which is usually
/// the speed. This test needs no estimate of the noise. Rows are sorted by run and all other
/// settings, then by the swept input. If no setting is swept, the time is used as the swept input.
/// The correlation is the mean product of neighbouring residuals divided by their mean square. For
/// pure noise, the correlation has a nearly normal distribution with variance 1/pairs. The p-value
/// is one-sided. Noise that drifts along a run also increases the correlation.
struct Pattern {
  const record::Channel* along = nullptr;
  double correlation = unset;  ///< in [-1, 1]; NaN with fewer than 8 pairs
  double p_value = unset;
  int pairs = 0;
};

/// Conclusion about a misfit. For a model that only approximates the readings, the tolerance
/// decides: `structure` means that the RMS error exceeds it, `noise` that it does not, and
/// `unknown` that no tolerance is given.
enum class Judgement {
  structure,  ///< systematic misfit: p < 0.01 in LackOfFit, or in Pattern if the noise is unknown
  noise,      ///< the misfit is no larger than the noise
  unknown     ///< the noise is unknown, and the residuals show no pattern
};

/// Comparison of a model with the readings of one channel. Residuals are prediction minus reading.
struct Comparison {
  const record::Channel* channel = nullptr;
  int rows = 0;  ///< number of compared rows
  /// RMS, mean absolute and largest absolute residual; mean residual [SI].
  double rmse = unset, mae = unset, max_abs = unset, bias = unset;
  /// 100 (1 - |y - ŷ| / |y - mean y|) in Euclidean norms, with readings y and predictions ŷ. A
  /// perfect prediction gives 100, and the mean of the readings as prediction gives 0. NaN if all
  /// readings are equal.
  double fit_percent = unset;
  fit::Noise noise{};
  /// RMS noise from estimate_unknown_noise() [SI]. NaN if this function was not called, if `noise`
  /// is known, or if the data do not determine the noise.
  double estimated_noise = unset;
  LackOfFit lack_of_fit{};
  Pattern pattern{};
  /// Correlation time of the residuals [s]; NaN unless the model approximates a record over time.
  double correlation_time = unset;
  std::string_view begins{};  ///< initial state of the simulation ("rest"); empty if there is none
  Judgement judgement = Judgement::unknown;
  double tolerance = unset;  ///< acceptable RMS error [SI]; NaN if not given
  /// Errors in ranges of each varying input and in runs, largest first. For a model that only
  /// approximates the readings, also errors in ranges of time.
  std::vector<ErrorRange> where{};
  std::vector<ErrorRange> records{};  ///< errors of each joined record, in the order of the records
  std::vector<RowError> worst{};      ///< the five rows with the largest residuals, largest first
  std::vector<RowError> errors{};     ///< all compared rows, in the order of the data
  std::vector<std::size_t> rows_not_predicted{};  ///< rows with a reading but without a prediction
  std::string statement{};  ///< text: RMS misfit, comparison with the noise, and worst range
};

/// Returns the noise of a measured channel from fit::estimate_noise(). For a model that only
/// approximates the readings, the noise is the standard deviation that the model declares. If the
/// model declares no standard deviation, the noise is the scatter of readings that are neighbours
/// in time.
[[nodiscard]] fit::Noise noise_of(const record::Record& record, const fit::Measured& measured);

/// Compares a model with every measured channel of the record. `fitted_parameters` is the number of
/// model parameters that were fitted to these data. Fitted parameters reduce the degrees of freedom
/// of the test. If you do not know the number, use 0, which makes the test less strict. Throws
/// std::invalid_argument if the record does not suit this kind of model, has no rows, or has a
/// measured channel without any prediction.
[[nodiscard]] std::vector<Comparison> compare(const fit::Subject& subject,
                                              const record::Record& record,
                                              int fitted_parameters = 0);

/// Compares one channel with given predictions: `predicted` has one value for each row of the
/// record; NaN marks a missing prediction.
[[nodiscard]] Comparison compare(std::span<const double> predicted, const record::Record& record,
                                 const fit::Measured& measured, int fitted_parameters = 0);

/// Adds the errors of groups of rows to Comparison::where. `group` names the group of each row; an
/// empty name means no group. `kind` is a channel with Role::run. Texts name a group by the
/// readable name of this channel (Channel::words) and the name of the group.
void add_groups(Comparison& comparison, const record::Channel& kind,
                const std::vector<std::string>& group);

/// Estimates the noise of channels with unknown noise: Comparison::estimated_noise and
/// RowError::std. The estimate comes from a saturated regression (fit::Saturation), as in a
/// diagnosis. For a model that only approximates the readings, `estimated_noise` is an upper bound
/// from noise_of_calm_readings(). The estimate does not change Comparison::judgement.
void estimate_unknown_noise(const fit::Subject& subject, const record::Record& record,
                            std::vector<Comparison>& comparisons);

/// Returns the text of a p-value: "p = 0.02".
[[nodiscard]] std::string p_value_text(double p);

}  // namespace raceway::verdict
