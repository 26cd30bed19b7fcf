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

/// Gain from the effects switched on, for one measured channel.
struct ChannelGain {
  Comparison before{}, after{};  ///< in sample, each refitted, over the same rows
  fit::NoiseModel noise{};       ///< by which readings were weighed, in the order of the errors
  double tolerance = unset;      ///< SI; NaN if not given
  /// Held-out errors of both fits [SI]; with a tolerance, within the measured range.
  double rmse_held_out_before = unset, rmse_held_out_after = unset;

  [[nodiscard]] const record::Channel& channel() const { return *before.channel; }
};

/// A subject with effects switched on, and what that bought.
struct AddResult {
  Calibration calibration;  ///< `calibration.subject` is the new one, all free parameters fitted
  std::vector<ChannelGain> channels{};
  std::vector<fit::HoldOut> hold_out{};  ///< blocks of rows that neither fit saw
  std::vector<fit::Refit> refits{};      ///< of a subject that only approximates: before, after
  fit::Likelihood before{};              ///< without them, under the same noise
  double gain = unset;                   ///< RankedEffect::gain, of all of them together
  bool refused = false;  ///< no better on rows it did not see, or the fit did not converge
  std::string reason{};  ///< why, in a sentence; empty where accepted
  std::vector<record::Note> messages{};
};

/// Switches candidates on by id, refits all free parameters with them and judges the result. Size
/// and standard error are those that diagnose() gives.
///
/// "shape" is the shape that a diagnosis gives of what is missing, as an effect of the user's own,
/// and the id of an OtherBase takes that base model, calibrated, in the place of the given one; it
/// is taken by itself. Both are judged as effects are.
///
/// Refused: what is not better on blocks of rows that the fit did not see (two of the blockings,
/// significantly worse in none); a fall of -2 ln L that chance could bring; a single effect that
/// leaves structure where another one explains the data to the noise.
///
/// Throws std::invalid_argument: no effect, an unknown one (with the nearest ids), one the subject
/// has already, one that the data cannot feed (with what they lack) or cannot tell from the base
/// parameters. Not of a subject that only approximates: see loop/loop.h.
[[nodiscard]] AddResult add_by_noise(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::verdict
