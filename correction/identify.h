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
  /// Columns that may drive additional channels. A channel is added only if it lowers the held-out
  /// error by more than 5 %; a section is added only if it lowers this error by more than 3 %.
  std::vector<const Channel*> offered{};
  std::size_t most_channels = 6;
  std::function<void(double share, std::string_view step)> progress{};
  std::function<bool()> cancelled{};  ///< identify() throws fit::Cancelled if this returns true
};

/// Channels and numbers of sections that were tried, with the held-out error.
struct StructureTried {
  std::vector<std::string> channels{};
  std::vector<int> orders{};                 ///< number of sections of each channel
  double rms_held_out = unset, rms = unset;  ///< [m]
  bool taken = false;
};

/// Result of a fit to the first part of the record, tested on all later readings.
struct AheadError {
  double from = unset;  ///< end of the fitted part, counted from the first row [s]
  double rms = unset;   ///< [m]
};

/// Ridge strength that was tried for a bank of lags: see lag_bank.h.
struct StrengthTried {
  double strength = unset;      ///< [um² per square of a gain in um/K, um/(m/min), um/1000 rpm]
  double speed_weight = unset;  ///< [1]
  double rms_ahead = unset;     ///< rms error on later readings, mean over the fitted parts [m]
  double share = unset;         ///< weight in the final gains [1]
};

/// A model identified from a record.
struct Identification {
  Model model{};                        ///< identified model with parameters, range and covariance
  std::vector<StructureTried> tried{};  ///< structures in the order of the search
  /// Fitted parameters with standard errors; a bank of lags has no standard errors.
  std::vector<record::Parameter> parameters{};
  std::vector<StrengthTried> strengths{};  ///< ridge strengths of a bank of lags
  std::vector<AheadError> ahead{};         ///< for a bank of lags: errors after each fitted part
  Metrics metrics{};                       ///< on the record, with a fitted zero for each run
  double rms_held_out = unset;             ///< [m]
  double condition = unset;
  double correlation_time = unset;   ///< correlation time of the residual [s]
  double whiteness_p_value = unset;  ///< p-value of the test that the residual is white noise
  double noise = unset;              ///< noise of a single reading [m]
  fit::NoiseSource noise_source = fit::NoiseSource::none;
  std::vector<std::string> at_bound{};
  std::vector<record::Note> messages{};

  [[nodiscard]] bool converged() const { return !parameters.empty(); }
  [[nodiscard]] bool is_bank() const { return !strengths.empty(); }
};

/// Returns a new channel that this column drives, without sections. The name of the channel comes
/// from the name of the column and differs from the channel names of `model`.
[[nodiscard]] DrivenChannel driven_by(const Channel& column, const Model& model);

/// Identifies the number of sections, the inputs and the parameters of a model from a record. Gains
/// and time constants come from variable projection with many starts. The error on eight held-out
/// parts selects the structure. This search uses means of neighbouring rows; at the end, the
/// parameters are fitted to the single rows. Gains, time constants and the kinematic law of `model`
/// are start values. Delay elements, and transfer functions with published coefficients, remain
/// unchanged.
///
/// Throws std::invalid_argument if the record lacks an input of the model or has too few readings.
[[nodiscard]] Identification identify(const Model& model, const record::Record& record,
                                      const IdentifyOptions& options = {});

}  // namespace raceway::correction
