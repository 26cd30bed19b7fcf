#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/noise.h"
#include "fit/subject.h"

namespace raceway::verdict {

/// Errors in one range of one input, or in one run. If the data contain only a few levels of the
/// input, each range is one level.
struct ErrorRange {
  const record::Channel* channel = nullptr;
  /// Smallest and largest value of the input in the range [SI]; for a run, the index of the run.
  double from = unset, to = unset;
  std::string run{};  ///< name of the run or of the record; empty for a range of an input
  int rows = 0;
  double rmse = unset;  ///< RMS error [SI]
  double bias = unset;  ///< mean of prediction minus reading [SI]

  [[nodiscard]] bool is_run() const { return channel->role == record::Role::run; }
};

/// Prediction and reading of one row [SI].
struct RowError {
  std::size_t row = 0;  ///< row index in the record
  int line = 0;         ///< line number in the file, for messages (Record::line())
  double predicted = unset;
  double measured = unset;
  double residual = unset;  ///< prediction minus reading
  double std = unset;       ///< standard deviation of the reading; NaN if unknown
  double sigmas = unset;    ///< `residual` divided by `std` [1]
};

/// Result of the lack-of-fit test, which compares the misfit with the noise. The source of the
/// noise (NoiseSource) determines the test:
///   declared or regression   statistic = χ²/degrees of freedom, χ² distribution
///   repeats                  statistic = lack of fit/pure error, F distribution
///   none                     no test: all values are NaN
/// For a spindle model or a correction (Subject::approximates()), compare() makes no lack-of-fit
/// test, and all values are NaN.
struct LackOfFit {
  double statistic = unset;
  double p_value = unset;
  /// Number of rows minus number of fitted parameters. If the noise comes from repeats, the number
  /// of different operating points replaces the number of rows.
  int degrees_of_freedom = 0;
  /// Degrees of freedom of the scatter within repeats (pure error); 0 if the noise does not come
  /// from repeats.
  int noise_degrees_of_freedom = 0;
};

/// Correlation between the residuals of neighbouring rows along the swept input. The swept input is
/// the first setting (such as a speed or load) with Channel::ratio = true, usually the speed.
/// Without such a setting, time replaces the swept input. The test needs no estimate of the noise.
/// Rows are sorted by run and all other settings, then by the swept input. The correlation is the
/// mean product of neighbouring residuals divided by their mean square. For pure noise, the
/// correlation is nearly normally distributed, with mean 0 and variance 1/`pairs`. The p-value is
/// one-sided. Sensor drift during a run also increases the correlation.
struct Pattern {
  const record::Channel* along = nullptr;
  /// From -1 to 1; NaN if there are fewer than 8 pairs of neighbouring rows.
  double correlation = unset;
  double p_value = unset;
  int pairs = 0;
};

/// Conclusion about a misfit. For a spindle model or a correction (Subject::approximates()), the
/// RMS error is compared with the tolerance instead of the noise: `structure` means that the RMS
/// error exceeds the tolerance, `noise` that the RMS error is within the tolerance, and `unknown`
/// that no tolerance is given.
enum class Judgement {
  structure,  ///< systematic misfit: p-value below 0.01 in LackOfFit or, if the noise is unknown,
              ///< in Pattern
  noise,      ///< the misfit is no larger than the noise
  unknown     ///< the noise is unknown, and the residuals show no pattern
};

/// Comparison of a model with the readings of one channel. Residuals are prediction minus reading.
struct Comparison {
  const record::Channel* channel = nullptr;
  int rows = 0;  ///< number of compared rows
  /// RMS, mean absolute and largest absolute residual; mean residual [SI].
  double rmse = unset, mae = unset, max_abs = unset, bias = unset;
  /// 100 (1 - |y - ŷ| / |y - mean y|) with readings y, predictions ŷ and the Euclidean norm |.|. A
  /// perfect prediction gives 100, and the mean of the readings as prediction gives 0. NaN if all
  /// readings are equal.
  double fit_percent = unset;
  fit::Noise noise{};
  /// RMS noise from estimate_unknown_noise() [SI]; NaN until this function is called. The value
  /// stays NaN if `noise` is already known, or if the data do not determine the noise.
  double estimated_noise = unset;
  LackOfFit lack_of_fit{};
  Pattern pattern{};
  /// Correlation time of the residuals of a spindle model or a correction [s]; NaN for other models
  /// and for records without time.
  double correlation_time = unset;
  /// Initial state of the simulation, for example "rest"; empty for a model without a simulation.
  std::string_view begins{};
  Judgement judgement = Judgement::unknown;
  double tolerance = unset;  ///< acceptable RMS error [SI]; NaN if not given
  /// Errors in each run, and in ranges of each input that varies; largest error first. For a
  /// spindle model or a correction, the list also contains errors in ranges of time.
  std::vector<ErrorRange> where{};
  std::vector<ErrorRange> records{};  ///< errors of each joined record, in the order of the records
  std::vector<RowError> worst{};      ///< the five rows with the largest residuals, largest first
  std::vector<RowError> errors{};     ///< all compared rows, in the order of the data
  std::vector<std::size_t> rows_not_predicted{};  ///< rows with a reading but without a prediction
  /// Text with the RMS misfit, its comparison with the noise, and the worst range.
  std::string statement{};
};

/// Returns the noise of a measured channel from fit::estimate_noise(). For a spindle model or a
/// correction (Subject::approximates()), the noise is the standard deviation that the model file
/// declares. Without a declared standard deviation, the noise is the scatter between successive
/// readings.
[[nodiscard]] fit::Noise noise_of(const record::Record& record, const fit::Measured& measured);

/// Compares a model with every measured channel of the record. `fitted_parameters` is the number of
/// model parameters that were fitted to these data. This number reduces the degrees of freedom of
/// the lack-of-fit test. If you do not know this number, use 0; the test then detects a misfit less
/// often. Throws std::invalid_argument if the record does not suit this kind of model, has no rows,
/// or has a measured channel without any prediction.
[[nodiscard]] std::vector<Comparison> compare(const fit::Subject& subject,
                                              const record::Record& record,
                                              int fitted_parameters = 0);

/// Compares one channel with given predictions: `predicted` has one value for each row of the
/// record; NaN marks a missing prediction.
[[nodiscard]] Comparison compare(std::span<const double> predicted, const record::Record& record,
                                 const fit::Measured& measured, int fitted_parameters = 0);

/// Adds the errors of groups of rows to Comparison::where. `group` contains the name of a group for
/// each row. The name is empty for a row that belongs to no group. `kind` is a channel with
/// Role::run. Texts refer to a group by the readable name of this channel (Channel::words) and the
/// name of the group.
void add_groups(Comparison& comparison, const record::Channel& kind,
                const std::vector<std::string>& group);

/// Estimates the noise of channels with unknown noise: Comparison::estimated_noise and
/// RowError::std. The estimate comes from the residuals of a regression of the readings on smooth
/// functions of the inputs and on all candidate effects (fit::Saturation), as in diagnose(). For a
/// spindle model or a correction, `estimated_noise` is an upper bound from
/// noise_of_calm_readings(). The estimate does not change Comparison::judgement.
void estimate_unknown_noise(const fit::Subject& subject, const record::Record& record,
                            std::vector<Comparison>& comparisons);

/// Returns the text of a p-value: "p = 0.02".
[[nodiscard]] std::string p_value_text(double p);

}  // namespace raceway::verdict
