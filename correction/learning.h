#pragma once

#include <string>
#include <vector>

#include "correction/gauss_markov.h"
#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Settings for the correction of a model with readings of a probe that measures the displacement
/// occasionally.
struct LearningOptions {
  double every = 0.0;  ///< shortest time between two readings that are used [s]; 0: all are used
  /// Expected standard deviation of the residual of the model [m]. If it is NaN, the tolerance of
  /// the model is used; without a tolerance, usual_misfit.
  double misfit = unset;
  /// Standard deviation of the noise of a reading [m]. If it is NaN, `measured_std` of the model is
  /// used; if that is NaN as well, usual_reading_std.
  double reading_std = unset;
  /// Time constant with which learned gains return to the gains of the model [s].
  double forgetting = 7.0 * 24.0 * 3600.0;
  double gain_std = 0.1;    ///< expected standard deviation of the relative error of a gain [1]
  double gain_bound = 0.5;  ///< largest relative change of a gain of the model [1]
};

inline constexpr double usual_misfit = 2.0 * um;
inline constexpr double usual_reading_std = 0.3 * um;

/// A reading that learn() used or rejected. After a used reading, learn() skips the readings until
/// LearningOptions::every has elapsed.
struct OfferedReading {
  std::size_t row = 0;
  /// Reading, and its prediction from earlier readings [m].
  double reading = unset, predicted = unset;
  double std = unset;   ///< expected standard deviation of reading minus prediction [m]
  bool learnt = false;  ///< true: used for learning; false: rejected as too far from the prediction
  bool zeroed = false;  ///< true: the zero was reset with this reading
  /// Time from this reading until the standard deviation of the prediction exceeds the tolerance
  /// [s]; NaN if the tolerance is not exceeded before the next used reading, or if this reading was
  /// rejected.
  double good_for = unset;
};

/// A learned gain of a contribution of the model, or of an additional lag that the model lacks.
struct LearntGain {
  std::string name{};  ///< name of a channel or effect, "kinematic", or "spindle, lag of 2 h"
  /// Relative change of the gain of the model [1]. For an additional lag: displacement that the lag
  /// adds for half the range of its input [m].
  double value = 0.0;
  double std = unset;  ///< standard deviation of `value`, in the same unit
  bool is_lag = false, at_bound = false;
};

/// A reason to identify the model again, and the first row at which learn() finds this reason.
struct IdentificationDue {
  std::size_t row = 0;
  std::string reason{};
};

/// Rms errors of three predictions on the readings that learn() skips because of
/// LearningOptions::every [m]; NaN if it skips none.
struct ErrorBetween {
  std::size_t readings = 0;  ///< number of skipped readings
  /// Model without learning, aligned with the first used reading of each run.
  double first = unset;
  double zeroed = unset;  ///< model without learning, aligned with the latest used reading
  double learnt = unset;  ///< model with learning
};

struct Learning {
  std::vector<double> predicted{};  ///< prediction at every row from earlier readings [m]
  /// Standard deviation of the prediction [m]; NaN up to the first used reading of a run.
  std::vector<double> std{};
  std::vector<OfferedReading> readings{};
  std::vector<LearntGain> gains{};
  std::vector<IdentificationDue> due{};
  ErrorBetween error{};
  double tolerance = unset;  ///< tolerance of the model [m]
  /// Number of rows in which the standard deviation of the prediction exceeds the tolerance.
  std::size_t rows_beyond_tolerance = 0;
  /// Time from the last row until the standard deviation of the prediction exceeds the tolerance,
  /// if the inputs stay constant [s]. The time is infinite if it exceeds 30 days, and NaN if the
  /// model has no tolerance or the last run has no used reading.
  double next_reading = unset;
  double level = 1.0;  ///< ratio of the actual to the expected size of the residual [1]
  double misfit = unset, reading_std = unset;  ///< standard deviations that were used [m]
  Model model{};  ///< model with the learned gains and zero at the end of the record
};

/// Simulates a model over a record and corrects the prediction with occasional readings. The
/// prediction of a row uses only readings of earlier rows.
///
///   y = f(t) + z + sum_i d_i + sum_j a_j c_j(t) + sum_l b_l s_l(t) + v
///
/// y is the reading, and f is the prediction of the model with its contributions c_j. "Misfit" is
/// LearningOptions::misfit. The zero z of a run is unknown until its first reading. Afterwards z is
/// a random walk of one misfit per root of an hour, plus a drift of half a misfit per hour
/// (standard deviation) with a correlation time of 12 h. The d_i describe the residual as
/// independent processes: one with a correlation time of half an hour, and one for each longer time
/// constant of the model (at most 24 h) that is more than 1.5 times the next shorter correlation
/// time. The standard deviation of the sum of the d_i is a fifth of a misfit. The a_j are relative
/// changes of the contributions c_j. An effect that is valid only for the record of the fit has no
/// a_j. The b_l are gains of additional lags of the model inputs, with time constants of 0.5, 2 and
/// 8 h. s_l is the response of a lag divided by half the input range. The standard deviation of the
/// sum of all b_l is 2 misfits. All a_j and b_l return to 0 with the time constant `forgetting`. v
/// is the noise of a reading. One UnknownsFilter estimates all unknowns together. Their variances
/// are multiplied by level² (Learning::level), the mean ratio of the squared residual to its
/// expected variance over about the last 32 readings. The mean includes the expected ratio of 1
/// with the weight of 8 readings.
///
/// A reading is rejected if it differs from the prediction by more than 5 expected standard
/// deviations. The first reading of a run is never rejected. After a rejected reading, learn()
/// checks the next reading without waiting for LearningOptions::every. If the next reading also
/// exceeds this limit, learn() resets the zero in two cases: the reading agrees with the rejected
/// reading, or the two readings before it were rejected.
///
/// Source:   a Kalman filter. The standard deviations and times are our choice, based on the record
///           of docs/correction.md and on models fitted to three initial parts of this record.
/// Domain:   time records. A new setup_id is treated like a new run. A channel has additional lags
///           only if it has first-order lags and the model contains the range of its input.
/// Accuracy: the standard deviation of the prediction depends on the standard deviations and times
///           assumed above.
///
/// Throws std::invalid_argument if the record has no readings of the displacement or lacks an input
/// of the model.
[[nodiscard]] Learning learn(const Model& model, const record::Record& record,
                             const LearningOptions& options = {});

}  // namespace raceway::correction
