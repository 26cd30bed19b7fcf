#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results/sensitivity_results.h"
#include "session/messages.h"
#include "session/wording.h"
#include "spindle/spindle.h"

/// Computes the sensitivity of predictions to the input values of a model. A datum is one input
/// value of the model, such as the preload.
namespace raceway::session {

struct SensitivityQuestion {
  /// Predictions, each as a short name such as "torque" or as the name of a result column. An empty
  /// list means the torque of a bearing, or the displacement of a shaft or spindle.
  std::vector<std::string> predictions{};
  /// The operating points are all combinations of these values. Speeds are required. If a list of
  /// loads or temperatures is empty, the value of the model is used.
  std::vector<double> speeds_rpm{}, axial_loads_N{}, radial_loads_N{}, temperatures_C{};
  bool steady = false;  ///< true: steady state of the whole spindle at each speed
  bool coolant_on = true;
  /// Loads, ambient temperature and coolant of a steady state; empty: the values of the model. The
  /// speed in these inputs is not used, because `speeds_rpm` contains the speeds.
  std::optional<spindle::Inputs> inputs{};
  std::vector<files::SpreadText> spreads{};
  /// Names of the data to vary. The name of a table in the model file means all data of this table.
  /// An empty list means all data.
  std::vector<std::string> data{};
  std::size_t samples = 0;  ///< number of samples for the Sobol' indices; 0: no indices
  std::uint64_t seed = 1;
  Wording wording = Wording::flags;
  /// Function that is called with the model after it was read, for example to add an effect that is
  /// defined in Python; may be empty.
  std::function<void(files::ModelFile&)> amend{};
  const std::atomic<bool>* cancelled = nullptr;
  std::function<void(double)> progress{};  ///< receives the finished share of the work, 0 to 1
};

/// Returns the short names of the predictions of a model, each with the name of its result column,
/// for example "torque" and "friction_torque_Nmm".
[[nodiscard]] std::vector<std::pair<std::string, std::string>> sensitivity_words(
    const model::Model& model, bool steady);

/// Returns the derivative of each requested prediction with respect to each varied datum and, on
/// request, the Sobol' indices.
///
/// The derivative is (4 D(h/2) - D(h))/3, where D(h) is the central difference with step h. If the
/// model rejects the values on one side or has no prediction there, a one-sided difference of
/// second order with the steps h and h/2 replaces this formula. The step h is 0.1 % of the datum,
/// or 0.1 K for a temperature. For steady states of a spindle, the step is ten times larger,
/// because a steady state is found by iteration. For an integer datum such as the number of balls,
/// the derivative is D(1), or the one-sided difference with step 1.
///
/// The samples for the Sobol' indices are independent and uniformly distributed between value -
/// spread and value + spread. The spread of a datum is the value in SensitivityQuestion::spreads.
/// If no spread is given, the spread of a fitted parameter is sqrt(3) times its standard error. The
/// uniform distribution then has this standard error as its standard deviation. If no spread is
/// given, the spread of any other datum is 1 % of its value, 1 K for a temperature, and 1 for an
/// integer.
///
/// The calculation uses all cores. The results do not depend on the number of cores or on the order
/// of the operating points. Throws text::InputError for an unknown prediction, an unknown datum, or
/// a value outside its range. Throws fit::Cancelled if `cancelled` is set during the calculation.
[[nodiscard]] results::Sensitivity sensitivity(Messages& messages, const files::ModelFile& file,
                                               const SensitivityQuestion& question);

/// Returns one operating point as text, such as "speed_rpm 6000, axial_load_N 300".
[[nodiscard]] std::string words_of_state(const results::Sensitivity& s, std::size_t state);

/// Returns a warning for each prediction that has no value at an operating point with the unchanged
/// data of the model. One more warning is returned if some of the random samples for the Sobol'
/// indices have no prediction.
[[nodiscard]] std::vector<std::string> sensitivity_warnings(const results::Sensitivity& s);

}  // namespace raceway::session
