#pragma once

#include <string>
#include <vector>

#include "correction/gauss_markov.h"
#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Settings of learn(), which corrects the prediction of a model with occasional readings of the
/// displacement, for example from a probe.
struct LearningOptions {
  /// Shortest time between two readings that are used [s]; 0: use all readings.
  double every = 0.0;
  /// Expected standard deviation of the residual of the model [m]. If the value is NaN, the
  /// tolerance of the model is used. If the model has no tolerance, usual_misfit is used.
  double misfit = unset;
  /// Standard deviation of the noise of a reading [m]. If the value is NaN, Model::measured_std is
  /// used. If Model::measured_std is NaN too, usual_reading_std is used.
  double reading_std = unset;
  /// Time constant with which learned gains return to the gains of the model [s].
  double forgetting = 7.0 * 24.0 * 3600.0;
  double gain_std = 0.1;    ///< expected standard deviation of the relative error of a gain [1]
  double gain_bound = 0.5;  ///< largest relative change of a gain of the model [1]
};

inline constexpr double usual_misfit = 2.0 * um;
inline constexpr double usual_reading_std = 0.3 * um;

/// A reading that learn() used or rejected. After a used reading, learn() skips all readings within
/// the time LearningOptions::every.
struct OfferedReading {
  std::size_t row = 0;
  /// Reading, and its prediction from earlier readings [m].
  double reading = unset, predicted = unset;
  double std = unset;   ///< expected standard deviation of reading minus prediction [m]
  bool learnt = false;  ///< true: used for learning; false: rejected as too far from the prediction
  bool zeroed = false;  ///< true: the zero was reset with this reading
  /// Time from this reading until the standard deviation of the prediction exceeds the tolerance
  /// [s]. The value is NaN if this reading was rejected, or if the standard deviation stays within
  /// the tolerance until the next used reading.
  double good_for = unset;
};

/// Learned gain of a contribution of the model, or of an additional lag that learn() adds.
struct LearntGain {
  std::string name{};  ///< name of a channel or effect, "kinematic", or "spindle, lag of 2 h"
  /// Relative change of the gain of the model [1]. For an additional lag, the value is the final
  /// displacement of the lag after a change of the input by half of the input range [m].
  double value = 0.0;
  double std = unset;  ///< standard deviation of `value`, in the same unit
  bool is_lag = false, at_bound = false;
};

/// Reason to identify the model again, and the first row at which learn() finds this reason.
struct IdentificationDue {
  std::size_t row = 0;
  std::string reason{};
};

/// Rms errors of three predictions on the skipped readings [m]. learn() skips readings because of
/// LearningOptions::every. If no reading is skipped, the errors are NaN.
struct ErrorBetween {
  std::size_t readings = 0;  ///< number of skipped readings
  /// Model without learning, shifted to agree with the first used reading of each run.
  double first = unset;
  double zeroed = unset;  ///< model without learning, shifted to agree with the latest used reading
  double learnt = unset;  ///< model with learning
};

struct Learning {
  std::vector<double> predicted{};  ///< prediction at every row from earlier readings [m]
  /// Standard deviation of the prediction [m]; NaN (unknown) up to the first used reading of a run.
  std::vector<double> std{};
  std::vector<OfferedReading> readings{};
  std::vector<LearntGain> gains{};
  std::vector<IdentificationDue> due{};
  ErrorBetween error{};
  double tolerance = unset;  ///< tolerance of the model [m]
  /// Number of rows in which the standard deviation of the prediction exceeds the tolerance.
  std::size_t rows_beyond_tolerance = 0;
  /// Time after which a new reading is necessary [s]. At this time after the last row, the standard
  /// deviation of the prediction exceeds the tolerance if the inputs stay constant. A time above 30
  /// days is returned as infinite. The value is NaN if the model has no tolerance or the last run
  /// has no used reading.
  double next_reading = unset;
  double level = 1.0;  ///< ratio of the actual to the expected size of the residual [1]
  /// Values that learn() has used for the settings of these names in LearningOptions [m].
  double misfit = unset, reading_std = unset;
  Model model{};  ///< model with the learned gains and zero at the end of the record
};

/// Simulates a model over a record and corrects the prediction with occasional readings. The
/// prediction of a row uses only readings of earlier rows.
///
///   y = f(t) + z + sum_i d_i + sum_j a_j c_j(t) + sum_l b_l s_l(t) + v
///
///   y     reading of the displacement
///   f     prediction of the model; f contains the contributions c_j
///   z     zero (constant offset) of the run
///   d_i   slowly changing parts of the residual
///   a_j   relative change of the contribution c_j
///   b_l   gain of an additional lag of a model input; time constants: 0.5, 2 and 8 h
///   s_l   response of this lag, divided by half the range of its input
///   v     noise of the reading
///
/// In the following, m is LearningOptions::misfit, the expected standard deviation of the residual.
///
/// z is unknown until the first reading of a run. Afterwards z changes by a random walk and by a
/// drift. The random walk has a standard deviation of m after one hour. The rate of the drift has a
/// standard deviation of m/2 per hour and a correlation time of 12 h.
///
/// The d_i are independent processes, and their sum has a standard deviation of m/5. One process
/// has a correlation time of half an hour. The correlation times of the other processes are time
/// constants of the model, up to 24 h. A time constant is used only if it is more than 1.5 times
/// the next shorter correlation time.
///
/// All a_j and b_l return to 0 with the time constant LearningOptions::forgetting. The standard
/// deviation of the sum of all b_l is twice the misfit m. An effect that is valid only for the
/// record of the fit has no a_j.
///
/// A Kalman filter (UnknownsFilter) estimates all unknowns together. The variances of the unknowns
/// are multiplied by level² (Learning::level). level² is the mean ratio of the squared residual to
/// its expected variance over about the last 32 readings. The mean also contains the expected
/// ratio, which is 1, with the weight of 8 readings.
///
/// A reading is rejected if it differs from the prediction by more than 5 expected standard
/// deviations. The first reading of a run is never rejected. After a rejected reading, learn()
/// checks the next reading immediately, even if LearningOptions::every has not elapsed. If this
/// reading also exceeds the limit, it is rejected too, except in two cases: its error equals the
/// error of the previous reading (within 5 standard deviations), or both previous readings were
/// rejected. In these cases, learn() uses the reading and resets the zero.
///
/// Source:   a Kalman filter. The standard deviations and times above are assumptions. They are
///           based on the record of docs/correction.md and on models fitted to three initial parts
///           of this record.
/// Domain:   time records. A new setup_id is treated like a new run. Additional lags are used for
///           channels that have first-order lags and whose input range is in the model.
/// Accuracy: the standard deviation of the prediction is only as accurate as the standard
///           deviations and times that are assumed above.
///
/// Throws std::invalid_argument if the record has no readings of the displacement or lacks an input
/// of the model.
[[nodiscard]] Learning learn(const Model& model, const record::Record& record,
                             const LearningOptions& options = {});

}  // namespace raceway::correction
