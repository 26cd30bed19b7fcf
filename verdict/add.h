#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/hold_out.h"
#include "fit/refit.h"
#include "record/note.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"

namespace raceway::verdict {

/// Errors of one measured channel without and with the added effects.
struct ChannelGain {
  /// Errors without and with the effects. The model is refitted to the same rows in both cases.
  Comparison before{}, after{};
  /// Noise of the readings, which determines the weights of the readings in the fit. Reading i of
  /// `noise` belongs to `before.errors[i]` and `after.errors[i]`.
  fit::NoiseModel noise{};
  double tolerance = unset;  ///< acceptable RMS error [SI]; NaN if not given
  /// Held-out RMS errors without and with the effects [SI]; NaN if no rows can be held out. If a
  /// tolerance is given, the blocks of rows with the lowest and the highest values of an input are
  /// not held out.
  double rmse_held_out_before = unset, rmse_held_out_after = unset;

  [[nodiscard]] const record::Channel& channel() const { return *before.channel; }
};

/// Model with added effects, compared with the model without these effects.
struct AddResult {
  /// Fit of all free parameters of the new model. The new model itself is `calibration.subject`.
  Calibration calibration;
  std::vector<ChannelGain> channels{};
  /// Errors of the models without and with the effects, on held-out blocks of rows.
  std::vector<fit::HoldOut> hold_out{};
  /// Refits without and with the effects, for a spindle model or a correction
  /// (Subject::approximates()); empty for other models.
  std::vector<fit::Refit> refits{};
  fit::Likelihood before{};  ///< likelihood without the effects, with the noise of `calibration`
  double gain = unset;       ///< gain of all added effects together (RankedEffect::gain) [1]
  bool refused = false;      ///< true if add_by_noise() rejects the result
  std::string reason{};      ///< reason for the rejection; empty if the result is accepted
  std::vector<record::Note> messages{};
};

/// Adds the effects with these ids to the model, refits all free parameters, and accepts or rejects
/// the result. The function uses the same fit as diagnose(), so it gives the same sizes and
/// standard errors of the effects.
///
/// The id "shape" adds a power law of the inputs that is fitted to the misfit. The id of an
/// OtherBase, such as "law:skf", replaces the base law of the model and must be the only id. A
/// power law or a base law is accepted or rejected by the same rules as an effect.
///
/// The function rejects the added effects in these cases:
///   - The fit does not converge.
///   - The hold-out tests do not confirm the effects (fit::confirmed()).
///   - The decrease of -2 ln L (L: likelihood) may be due to chance.
///   - The held-out error without the effects is already within the tolerance. The noise is
///     subtracted from this error first: sqrt(error² - noise²).
///   - One of several added effects does not improve a fit that contains the other effects.
///   - After a single effect is added, the residual is still systematic, although another effect in
///     its place would leave only noise.
///
/// Throws std::invalid_argument in these cases:
///   - No id is given, or an id is unknown. For an unknown id, the message gives similar ids.
///   - The model already contains the effect.
///   - The data lack an input of the effect. The message gives the name of the input.
///   - The free parameters of the model change the readings in the same way as the effect.
///
/// For a spindle model or a correction (Subject::approximates()), use add() in loop/loop.h.
[[nodiscard]] AddResult add_by_noise(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::verdict
