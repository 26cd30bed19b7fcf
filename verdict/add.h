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

/// Improvement of one measured channel when the effects are switched on.
struct ChannelGain {
  Comparison before{}, after{};  ///< errors in sample; both models are refitted to the same rows
  fit::NoiseModel noise{};       ///< noise that weighs the readings, in the order of the errors
  double tolerance = unset;      ///< tolerance in SI units; NaN if not given
  /// Held-out errors of both fits [SI]. If a tolerance is given, they cover the measured range
  /// only.
  double rmse_held_out_before = unset, rmse_held_out_after = unset;

  [[nodiscard]] const record::Channel& channel() const { return *before.channel; }
};

/// A model with effects switched on, and the gain from these effects.
struct AddResult {
  /// `calibration.subject` is the new model with all free parameters fitted
  Calibration calibration;
  std::vector<ChannelGain> channels{};
  std::vector<fit::HoldOut> hold_out{};  ///< blocks of rows that neither fit used
  std::vector<fit::Refit> refits{};  ///< refits of a model that only approximates: before, after
  fit::Likelihood before{};  ///< likelihood of the model without the effects, under the same noise
  double gain = unset;       ///< RankedEffect::gain for all the effects together
  bool refused = false;      ///< true if held-out rows do not improve or the fit did not converge
  std::string reason{};      ///< reason for the rejection in one sentence; empty if accepted
  std::vector<record::Note> messages{};
};

/// Switches candidates on by id, refits all free parameters and judges the result. Sizes and
/// standard errors agree with those of diagnose().
///
/// The id "shape" adds the empirical shape that a diagnosis finds for the missing effect. The id of
/// an OtherBase replaces the base model by this other one, calibrated; it must be the only id. Both
/// are judged like effects.
///
/// Refused: The result is rejected in three cases: the error does not improve on blocks of held-out
/// rows (it must improve in two of the blockings and get significantly worse in none); chance could
/// explain the fall of -2 ln L; or a single effect leaves structure although another effect
/// explains the data to the noise.
///
/// Throws std::invalid_argument without an effect, for an unknown effect (with the nearest ids),
/// for an effect that the model already has, for an effect whose inputs the data lack (with their
/// names), and for an effect that the data cannot separate from the base parameters. Models that
/// only approximate need loop/loop.h instead.
[[nodiscard]] AddResult add_by_noise(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::verdict
