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
  int lowest_order = 1, highest_order = 3;  ///< range for the number of sections of a channel
  /// Columns that may drive additional channels. Channels are added one at a time, as long as each
  /// one lowers the held-out error by more than 5 %.
  std::vector<const Channel*> offered{};
  std::size_t most_channels = 6;
  std::function<void(double share, std::string_view step)> progress{};
  std::function<bool()> cancelled{};  ///< identify() throws fit::Cancelled if this returns true
};

/// A structure that was tried, with its held-out error.
struct StructureTried {
  std::vector<std::string> channels{};
  std::vector<int> orders{};                 ///< number of sections of each channel
  double rms_held_out = unset, rms = unset;  ///< [m]
  bool taken = false;
};

/// Result of a fit to the first part of the record, tested on all later readings.
struct AheadError {
  double from = unset;  ///< end of the fitted part, after the first row [s]
  double rms = unset;   ///< [m]
};

/// Ridge strength that was tried: see lag_bank.h.
struct StrengthTried {
  double strength = unset;      ///< [um² per square of a gain in um/K, um/(m/min), um/1000 rpm]
  double speed_weight = unset;  ///< [1]
  double rms_ahead = unset;     ///< mean rms error over all cuts [m]
  double share = unset;         ///< weight in the final gains [1]
};

/// A model identified from a record.
struct Identification {
  Model model{};                        ///< identified model with parameters, range and covariance
  std::vector<StructureTried> tried{};  ///< structures in the order of the search
  /// Fitted parameters of the model with standard errors.
  std::vector<record::Parameter> parameters{};
  std::vector<StrengthTried> strengths{};  ///< ridge strengths of a bank of lags
  std::vector<AheadError> ahead{};         ///< errors ahead of a bank of lags
  Metrics metrics{};                       ///< on the record, after subtracting one constant
  double rms_held_out = unset;             ///< [m]
  double condition = unset;
  double correlation_time = unset;   ///< correlation time of the residual [s]
  double whiteness_p_value = unset;  ///< p of the test that the residual is uncorrelated in time
  double noise = unset;              ///< noise of a single reading [m]
  fit::NoiseSource noise_source = fit::NoiseSource::none;
  std::vector<std::string> at_bound{};
  std::vector<record::Note> messages{};

  [[nodiscard]] bool converged() const { return !parameters.empty(); }
  [[nodiscard]] bool is_bank() const { return !strengths.empty(); }
};

/// Returns a channel of `model` that this column drives. The channel has the name of the column and
/// no sections.
[[nodiscard]] DrivenChannel driven_by(const Channel& column, const Model& model);

/// Identifies the order, inputs and parameters of a model from a record. Gains and time constants
/// come from variable projection with many starts. The error on eight held-out parts selects the
/// structure. At the end, the parameters are fitted to single rows. Gains, time constants and the
/// kinematic law of the model are start values. Printed coefficients and delay elements that depend
/// on the power remain unchanged.
///
/// Throws std::invalid_argument if the record lacks an input of the model or has too few readings.
[[nodiscard]] Identification identify(const Model& model, const record::Record& record,
                                      const IdentifyOptions& options = {});

}  // namespace raceway::correction
