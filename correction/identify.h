#pragma once

#include <functional>
#include <string>
#include <vector>

#include "correction/metrics.h"
#include "correction/model.h"
#include "fit/noise.h"
#include "record/note.h"
#include "tolerance/approximation.h"

namespace raceway::correction {

struct IdentifyOptions {
  int lowest_order = 1, highest_order = 3;  ///< sections of a channel
  /// Columns that may drive a channel of their own, in addition to the channels of the model: taken
  /// up one by one as long as the error on parts held out falls.
  std::vector<const Channel*> offered{};
  std::size_t most_channels = 6;
  std::function<void(double share, std::string_view step)> progress{};
  std::function<bool()> cancelled{};  ///< where it is true identify() throws fit::Cancelled
};

/// A structure that was tried, and how well it predicts what it did not see.
struct StructureTried {
  std::vector<std::string> channels{};
  std::vector<int> orders{};                 ///< of each channel
  double rms_held_out = unset, rms = unset;  ///< [m]
  bool taken = false;
};

/// A fit to a record up to a time, judged by all that comes after.
struct AheadError {
  double from = unset;  ///< since the first row [s]
  double rms = unset;   ///< [m]
};

/// A strength of ridge that was tried: see lag_bank.h.
struct StrengthTried {
  double strength = unset;      ///< [um² per square of a gain in um/K, um/(m/min), um/1000 rpm]
  double speed_weight = unset;  ///< [1]
  double rms_ahead = unset;     ///< mean of all cuts [m]
  double share = unset;         ///< in the gains that were taken [1]
};

/// A model whose structure and numbers come from a record.
struct Identification {
  Model model{};                                ///< with its numbers, range and covariance
  std::vector<StructureTried> tried{};          ///< in the order of the search
  std::vector<record::Parameter> parameters{};  ///< of the model, fitted, with standard errors
  std::vector<StrengthTried> strengths{};       ///< of a bank of lags
  std::vector<AheadError> ahead{};              ///< of a bank of lags
  Metrics metrics{};                            ///< on the record, one constant removed
  double rms_held_out = unset;                  ///< [m]
  double condition = unset;
  double correlation_time = unset;   ///< of the residual [s]
  double whiteness_p_value = unset;  ///< that the residual does not follow the rows before it
  double noise = unset;              ///< of a single reading [m]
  fit::NoiseSource noise_source = fit::NoiseSource::none;
  std::vector<std::string> at_bound{};
  std::vector<record::Note> messages{};

  [[nodiscard]] bool converged() const { return !parameters.empty(); }
  [[nodiscard]] bool is_bank() const { return !strengths.empty(); }
};

/// A channel of `model` that this column drives, named by it, without sections.
[[nodiscard]] DrivenChannel driven_by(const Channel& column, const Model& model);

/// Finds order, inputs and numbers of a model from a record: gains and time constants by variable
/// projection from many starts, the structure by the error on eight parts held out, the numbers at
/// last on single rows. Gains, time constants and kinematic law of the model are starts; delay
/// elements that go with the power and printed coefficients stay as they are.
///
/// Throws std::invalid_argument: a record without an input of the model, or with too few readings.
[[nodiscard]] Identification identify(const Model& model, const record::Record& record,
                                      const IdentifyOptions& options = {});

}  // namespace raceway::correction
