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
  /// Errors without and with the effects; both models are refitted to the same rows.
  Comparison before{}, after{};
  /// Noise of the readings, which determines their weights in the fit. An index of a reading in
  /// `noise` is its index in `before.errors` and in `after.errors`.
  fit::NoiseModel noise{};
  double tolerance = unset;  ///< acceptable RMS error [SI]; NaN if not given
  /// Held-out RMS errors without and with the effects [SI]; NaN if no rows can be held out. If a
  /// tolerance is given, the blocks with the lowest and the highest values of an input are not held
  /// out.
  double rmse_held_out_before = unset, rmse_held_out_after = unset;

  [[nodiscard]] const record::Channel& channel() const { return *before.channel; }
};

/// Model with added effects, and its gain over the model without them.
struct AddResult {
  /// `calibration.subject` is the new model with all free parameters fitted
  Calibration calibration;
  std::vector<ChannelGain> channels{};
  std::vector<fit::HoldOut> hold_out{};  ///< errors of both models on held-out blocks of rows
  /// Refits without and with the effects, for a model that only approximates the readings
  /// (Subject::approximates()); empty for other models.
  std::vector<fit::Refit> refits{};
  fit::Likelihood before{};  ///< likelihood of the model without the effects, with the same noise
  double gain = unset;       ///< gain of all effects together; see RankedEffect::gain
  bool refused = false;      ///< true if the result is rejected by a rule of add_by_noise()
  std::string reason{};      ///< reason for the rejection in one sentence; empty if accepted
  std::vector<record::Note> messages{};
};

/// Adds the effects with these ids to the model, refits all free parameters, and accepts or rejects
/// the result. Sizes of the effects and their standard errors agree with the results of diagnose().
///
/// The id "shape" adds a power law of the inputs that is fitted to the misfit. The id of an
/// OtherBase, such as "law:skf", replaces the base law of the model and must be the only id. A
/// power law or a base law is accepted or rejected by the same rules as an effect.
///
/// The result is rejected if the fit does not converge, and in five more cases. First: the held-out
/// error does not fall. It must fall in two hold-out tests (Judged::blockings()), or in all if
/// there are fewer, and must not rise significantly in any. Second: the fall of -2 ln L (L:
/// likelihood) may be due to chance. Third: a tolerance is given, and the parts of the held-out
/// errors without the effects that the noise does not explain are within the tolerances. Fourth:
/// one of several added effects does not improve the fit if the others are in the model. Fifth: the
/// residual is systematic after a single effect was added, but would be only noise if another
/// effect were added instead.
///
/// Throws std::invalid_argument if no id is given, for an unknown id (the message gives the nearest
/// ids), for an effect that the model already has, for an effect whose inputs the data lack (the
/// message gives their names), and for an effect that the data cannot separate from the free
/// parameters of the model. For models that only approximate the readings
/// (Subject::approximates()), use add() in loop/loop.h.
[[nodiscard]] AddResult add_by_noise(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::verdict
