#pragma once

#include <string>
#include <vector>

#include "correction/gauss_markov.h"
#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Settings for learning from a probe that measures the displacement occasionally.
struct LearningOptions {
  double every = 0.0;  ///< shortest time between two offered readings [s]; 0: offer all
  /// Standard deviation of the model residual [m]. NaN means the tolerance of the model, or
  /// usual_misfit if the model has no tolerance.
  double misfit = unset;
  double reading_std = unset;  ///< [m]; NaN: measured_std of the model, otherwise usual_reading_std
  /// Time constant with which gains return to the values of the model [s].
  double forgetting = 7.0 * 24.0 * 3600.0;
  double gain_std = 0.1;    ///< standard deviation of a relative gain error [1]
  double gain_bound = 0.5;  ///< largest relative change of a gain of the model [1]
};

inline constexpr double usual_misfit = 2.0 * um;
inline constexpr double usual_reading_std = 0.3 * um;

/// A reading that was offered for learning, and its result.
struct OfferedReading {
  std::size_t row = 0;
  /// Reading and prediction [m]; the prediction does not yet use this reading.
  double reading = unset, predicted = unset;
  double std = unset;   ///< expected standard deviation of reading minus prediction [m]
  bool learnt = false;  ///< true: used for learning; false: rejected as too far from the prediction
  bool zeroed = false;  ///< true: this reading reset the zero
  double good_for = unset;  ///< time until the uncertainty exceeds the tolerance [s]
};

/// A learned gain: of a part of the model, or of a lag that the model lacks.
struct LearntGain {
  std::string name{};  ///< name of a channel or effect, "kinematic", or "spindle, lag of 2 h"
  /// Relative difference from the gain of the model [1]. For a lag that the model lacks:
  /// displacement that the lag adds for half the range of its input [m].
  double value = 0.0;
  double std = unset;  ///< standard deviation, in the unit of `value`
  bool is_lag = false, at_bound = false;
};

/// Reason why the model should be identified again.
struct IdentificationDue {
  std::size_t row = 0;
  std::string reason{};
};

/// Rms error over the readings that were not offered and that follow the first learned reading of
/// their run [m].
struct ErrorBetween {
  std::size_t readings = 0;
  /// Model without learning; its zero comes from the first reading of each run.
  double first = unset;
  double zeroed = unset;  ///< model without learning; its zero comes from the last learned reading
  double learnt = unset;
};

struct Learning {
  std::vector<double> predicted{};  ///< at every row, from earlier readings only [m]
  std::vector<double> std{};  ///< std of the prediction [m]; NaN up to the first reading of a run
  std::vector<OfferedReading> readings{};
  std::vector<LearntGain> gains{};
  std::vector<IdentificationDue> due{};
  ErrorBetween error{};
  double tolerance = unset;  ///< [m]
  /// Number of rows in which the uncertainty of the prediction exceeds the tolerance.
  std::size_t rows_beyond_tolerance = 0;
  /// Time from the last row until the uncertainty of the prediction exceeds the tolerance, with
  /// constant inputs [s]. The time is infinite if it exceeds 30 days, and NaN if the model has no
  /// tolerance or the last run has no learned reading.
  double next_reading = unset;
  double level = 1.0;  ///< ratio of actual to expected residual of the model [1]
  double misfit = unset, reading_std = unset;  ///< values that were used [m]
  Model model{};  ///< model with gains and zero at the end of the record
};

/// Simulates a model over a record and corrects the prediction with each offered reading. The
/// prediction of a row uses only readings of earlier rows.
///
///   y = f(t) + z + sum_i d_i + sum_j a_j c_j(t) + sum_l b_l s_l(t) + v
///
/// f is the model with the contributions c_j. The zero z of the run is unknown until its first
/// reading. Afterwards z is a random walk of one misfit per root of an hour, plus a drift of half a
/// misfit per hour with a memory of 12 h. The d_i describe the residual and the errors in the
/// states of slow sections. One process has a memory of half an hour, and there is one further
/// process for each slow time constant. The joint standard deviation of these processes is a fifth
/// of a misfit. The a_j are relative changes of the contributions c_j. The b_l are gains of lags
/// that the model lacks: lags of 0.5, 2 and 8 h of the model inputs. The responses s_l are in units
/// of half the input range. The joint standard deviation of all these lags is 2 misfits. All a and
/// b return to 0 with the forgetting time. v is the noise of a reading. One UnknownsFilter
/// estimates all unknowns together. The readings determine the size of these unknowns relative to
/// v: the variance of the unknowns is multiplied by level². level² is the mean ratio of actual to
/// expected variance over about the last 32 readings. The mean includes the expected ratio of 1
/// with the weight of 8 readings.
///
/// A reading is rejected if it differs from the prediction by more than 5 expected standard
/// deviations. The next reading is then offered regardless of the interval. A next reading that is
/// also outside this limit resets the zero in two cases: it agrees with the rejected reading, or
/// the two readings before it were rejected.
///
/// Source:   a Kalman filter. Sizes and times are our choice, based on the record of
///           docs/correction.md with models from three initial parts of this record.
/// Domain:   records over time. A lag is added to a channel only if the model contains the range of
///           its input.
/// Accuracy: the standard deviation depends on the sizes and times assumed above.
///
/// Throws std::invalid_argument if the displacement column, all readings or an input are missing.
[[nodiscard]] Learning learn(const Model& model, const record::Record& record,
                             const LearningOptions& options = {});

}  // namespace raceway::correction
