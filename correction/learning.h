#pragma once

#include <string>
#include <vector>

#include "correction/gauss_markov.h"
#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Settings for learning from a probe that reads the displacement now and then.
struct LearningOptions {
  double every = 0.0;  ///< [s] at least between two readings that are offered; 0: all
  /// Standard deviation of the residual of the model [m]; NaN: its tolerance, else usual_misfit.
  double misfit = unset;
  double reading_std = unset;  ///< [m]; NaN: measured_std of the model, else usual_reading_std
  double forgetting = 7.0 * 24.0 * 3600.0;  ///< memory of gains: they return to the model's [s]
  double gain_std = 0.1;                    ///< by which gains may be wrong, as a share [1]
  double gain_bound = 0.5;                  ///< beyond which no gain goes, as a share [1]
};

inline constexpr double usual_misfit = 2.0 * um;
inline constexpr double usual_reading_std = 0.3 * um;

/// Result for a reading that a probe offered.
struct OfferedReading {
  std::size_t row = 0;
  double reading = unset, predicted = unset;  ///< [m]; the prediction before it was learnt
  double std = unset;                         ///< of their difference, as expected [m]
  bool learnt = false;                        ///< otherwise refused: too far from what was expected
  bool zeroed = false;                        ///< the zero was taken anew from it
  double good_for = unset;  ///< [s] after it the prediction is no longer as sure as the tolerance
};

/// A part of the model whose size is learnt.
struct LearntGain {
  std::string name{};  ///< of the channel or the effect; "kinematic"; of a lag with its time
  /// Relative difference to the model [1]; for a lag that the model lacks, the displacement by half
  /// the range of the input [m].
  double value = 0.0;
  double std = unset;  ///< the same
  bool is_lag = false, at_bound = false;
};

/// Reason to identify the model anew.
struct IdentificationDue {
  std::size_t row = 0;
  std::string reason{};
};

/// Root mean square of readings that were not offered, behind the first that was learnt [m].
struct ErrorBetween {
  std::size_t readings = 0;
  double first = unset;   ///< of the model, with its zero from the first reading of each run
  double zeroed = unset;  ///< of the model, with its zero from the last reading
  double learnt = unset;
};

struct Learning {
  std::vector<double> predicted{};  ///< at every row, from readings before it alone [m]
  std::vector<double> std{};        ///< of it [m]; NaN before the first reading of a run
  std::vector<OfferedReading> readings{};
  std::vector<LearntGain> gains{};
  std::vector<IdentificationDue> due{};
  ErrorBetween error{};
  double tolerance = unset;               ///< [m]
  std::size_t rows_beyond_tolerance = 0;  ///< less sure than the tolerance
  /// Time after the last row, with its inputs, until the uncertainty of the prediction exceeds the
  /// tolerance [s]: 0 now, infinite never; NaN without a tolerance or a reading.
  double next_reading = unset;
  double level = 1.0;  ///< of what the model leaves over what was expected of it [1]
  double misfit = unset, reading_std = unset;  ///< as used [m]
  Model model{};  ///< with the gains and the zero as they stand at the end
};

/// Runs a model over a record and corrects it by the readings as they come: the prediction of a row
/// rests on readings of rows before it alone.
///
///   y = f(t) + z + sum_i d_i + sum_j a_j c_j(t) + sum_l b_l s_l(t) + v
///
/// f: the model, with contributions c_j. z: zero of the run, unknown until its first reading, then
/// a random walk by one misfit in the root of an hour, and a drift by half a misfit an hour with a
/// memory of 12 h. d_i: the residual and errors in the states of the slow sections of the model, a
/// process for half an hour and each slow time constant, together a fifth of a misfit. a_j: shares
/// by which contributions are larger. b_l: lags of 0.5, 2 and 8 h of the inputs that the model
/// lacks, s_l in half ranges of the input, together 2 misfits. a and b return to 0 with the
/// forgetting time. v: noise of a reading. All are estimated at once by an UnknownsFilter. Their
/// size relative to v follows from the readings: their variance is multiplied by level², the mean
/// ratio of actual to expected variance over about the last 32 readings, with the expectation of
/// the model counted as 8.
///
/// A reading further off than 5 expected standard deviations is refused, and the next one is
/// offered whatever the interval. If it agrees with the refused one, or two before it were refused,
/// the zero is set anew.
///
/// Source:   a Kalman filter; sizes and times are ours, chosen on the record of docs/correction.md
///           with models of three beginnings of it.
/// Domain:   records over time; a lag is sought where the model knows the range of its input.
/// Accuracy: physical; the standard deviation rests on these assumptions.
///
/// Throws std::invalid_argument: no column of the displacement, no reading, an input missing.
[[nodiscard]] Learning learn(const Model& model, const record::Record& record,
                             const LearningOptions& options = {});

}  // namespace raceway::correction
