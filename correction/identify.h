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
  int lowest_order = 1, highest_order = 3;  ///< limits for the number of lags in a channel
  /// Record columns that may drive additional channels. A channel is added if it lowers the
  /// held-out error by more than 5 %. A lag is added to a channel if it lowers the held-out error
  /// by more than 3 %.
  std::vector<const Channel*> offered{};
  std::size_t most_channels = 6;
  std::function<void(double share, std::string_view step)> progress{};
  /// If this function returns true, identify() throws fit::Cancelled.
  std::function<bool()> cancelled{};
};

/// A model structure (channels and their numbers of lags) that identify() tried, and its errors.
struct StructureTried {
  std::vector<std::string> channels{};
  std::vector<int> orders{};  ///< number of lags in each channel
  /// `rms_held_out` is the rms error on held-out parts of the record, and `rms` is the rms residual
  /// of the fit [m].
  double rms_held_out = unset, rms = unset;
  bool taken = false;
};

/// Error of a model that is fitted to an initial part of a record and predicts all later readings.
struct AheadError {
  double from = unset;  ///< duration of the initial part, to which the model is fitted [s]
  double rms = unset;   ///< rms error on the later readings [m]
};

/// Ridge strength λ and speed weight s that identify_lag_bank() tried. lag_bank.h explains both
/// numbers.
struct StrengthTried {
  /// λ [um² per square of the unit of a gain: um/K, um/(m/min) or um/1000 rpm].
  double strength = unset;
  double speed_weight = unset;  ///< weight s of speeds in the ridge penalty [1]
  /// RMS error of a model that is fitted to an initial part of the record and predicts all later
  /// readings [m]. The value is the mean over several initial parts of different length.
  double rms_ahead = unset;
  /// Weight of this pair of λ and s [1]. The gains of the model are the weighted mean over all
  /// tried pairs.
  double share = unset;
};

/// A model identified from a record.
struct Identification {
  Model model{};  ///< model with fitted parameters, input ranges and covariance
  std::vector<StructureTried> tried{};  ///< structures in the order of the search
  /// Fitted parameters with standard errors. A bank of lags has no standard errors.
  std::vector<record::Parameter> parameters{};
  std::vector<StrengthTried> strengths{};  ///< for a bank of lags: ridge strengths that were tried
  std::vector<AheadError> ahead{};         ///< for a bank of lags: one error per initial part
  Metrics metrics{};            ///< errors on the whole record, with a fitted offset for each run
  double rms_held_out = unset;  ///< rms error on held-out readings [m]
  double condition = unset;
  double correlation_time = unset;  ///< correlation time of the residual [s]
  /// P-value of the Ljung-Box test for white noise in the residual, over 20 lags; NaN for fewer
  /// than 60 residuals.
  double whiteness_p_value = unset;
  double noise = unset;  ///< standard deviation of the noise of a reading [m]
  fit::NoiseSource noise_source = fit::NoiseSource::none;
  std::vector<std::string> at_bound{};
  std::vector<record::Note> messages{};

  [[nodiscard]] bool converged() const { return !parameters.empty(); }
  [[nodiscard]] bool is_bank() const { return !strengths.empty(); }
};

/// Returns a new channel with this column as input. The channel has no lags. Its name is made from
/// the name of the column and differs from the channel names of `model`.
[[nodiscard]] DrivenChannel driven_by(const Channel& column, const Model& model);

/// Identifies the inputs, the number of lags and the parameters of a model from a record. Gains and
/// time constants are fitted by variable projection with many starts. The program adds channels and
/// lags while the rms error on eight held-out parts decreases sufficiently (see IdentifyOptions).
/// If no part can be held out, the rms error of the fit decides. The search uses means of
/// neighbouring rows. The final fit of the parameters uses the original rows. Gains, time constants
/// and the kinematic law of `model` are start values. Delay elements and transfer functions with
/// published coefficients remain unchanged.
///
/// Throws std::invalid_argument if the record lacks an input of the model or has fewer than three
/// independent readings per parameter, or if neither `model` nor `offered` has an input.
[[nodiscard]] Identification identify(const Model& model, const record::Record& record,
                                      const IdentifyOptions& options = {});

}  // namespace raceway::correction
