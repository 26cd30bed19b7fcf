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

/// Sensitivity of predictions to the data of a model.
namespace raceway::session {

struct SensitivityQuestion {
  /// Words as "torque" or names of columns; empty: the torque of a bearing, the displacement of a
  /// shaft or a spindle.
  std::vector<std::string> predictions{};
  /// States: all combinations. Speeds are required; empty others come from the model.
  std::vector<double> speeds_rpm{}, axial_loads_N{}, radial_loads_N{}, temperatures_C{};
  bool steady = false;  ///< of a whole spindle, where its speed leads
  bool coolant_on = true;
  /// Loads, room and coolant of a steady state, whose speed does not count; nothing: the model.
  std::optional<spindle::Inputs> inputs{};
  std::vector<files::SpreadText> spreads{};
  /// Names of the data that are varied, or of tables with all that is in them; empty: all.
  std::vector<std::string> data{};
  std::size_t samples = 0;  ///< of global indices; 0: none
  std::uint64_t seed = 1;
  Wording wording = Wording::flags;
  /// Changes the model as read to the question, beyond its file.
  std::function<void(files::ModelFile&)> amend{};
  const std::atomic<bool>* cancelled = nullptr;
  std::function<void(double)> progress{};  ///< called with the share that is done
};

/// Predictions of a model that can be requested: words, and the columns that they stand for.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> sensitivity_words(
    const model::Model& model, bool steady);

/// Derivatives of every prediction by every datum, and on request the indices of Sobol'.
///
/// A derivative is the central difference at two steps, h and h/2, extrapolated:
/// (4 D(h/2) - D(h))/3; to one side where the model takes no value on the other. h is a tenth of
/// 1 % of the datum, 0.1 K of a temperature, ten times that for a spindle, whose steady state is
/// found by iterations; 1 of a count, without a second step.
///
/// Spreads: what the question gives; else sqrt(3) times the standard error that the model carries
/// of a fitted number, which is half the width of the even distribution of that standard deviation;
/// else 1 % of the value, 1 K of a temperature, 1 of a count. Global samples are even from value -
/// spread to value + spread, independent of each other.
///
/// Points are solved on all cores; neither their number nor their order changes a digit. Throws
/// text::InputError for a wrong question, fit::Cancelled where `cancelled` is set meanwhile.
[[nodiscard]] results::Sensitivity sensitivity(Messages& messages, const files::ModelFile& file,
                                               const SensitivityQuestion& question);

/// "speed_rpm 6000, axial_load_N 300" of a state.
[[nodiscard]] std::string words_of_state(const results::Sensitivity& s, std::size_t state);

/// Predictions without a value, one line each.
[[nodiscard]] std::vector<std::string> sensitivity_warnings(const results::Sensitivity& s);

}  // namespace raceway::session
