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

/// Errors of one measured channel without and with the effects.
struct ChannelGain {
  Comparison before{}, after{};  ///< errors in sample; both models are refitted to the same rows
  /// Noise model that determines the weights of the readings. The readings in `noise` are in the
  /// order of Comparison::errors.
  fit::NoiseModel noise{};
  double tolerance = unset;  ///< tolerance in SI units; NaN if not given
  /// Held-out errors of both fits [SI]. If a tolerance is given, these errors cover the measured
  /// range only.
  double rmse_held_out_before = unset, rmse_held_out_after = unset;

  [[nodiscard]] const record::Channel& channel() const { return *before.channel; }
};

/// A model with effects switched on, and the gain from these effects.
struct AddResult {
  /// `calibration.subject` is the new model with all free parameters fitted
  Calibration calibration;
  std::vector<ChannelGain> channels{};
  std::vector<fit::HoldOut> hold_out{};  ///< blocks of rows that neither fit used
  /// Refits without and with the effects, for a model that only approximates the readings
  /// (Subject::approximates()).
  std::vector<fit::Refit> refits{};
  fit::Likelihood before{};  ///< likelihood of the model without the effects, with the same noise
  double gain = unset;       ///< gain of all effects together, as in RankedEffect
  bool refused = false;      ///< true if the result is rejected; see add_by_noise()
  std::string reason{};      ///< reason for the rejection in one sentence; empty if accepted
  std::vector<record::Note> messages{};
};

/// Switches candidates on by id, refits all free parameters and judges the result. Sizes and
/// standard errors agree with the results of diagnose().
///
/// The id "shape" adds the empirical shape that a diagnosis finds for the missing effect. The id of
/// an OtherBase replaces the base model by the calibrated other base model. The id of an OtherBase
/// must be the only id. Shapes and base models are judged like effects.
///
/// The result is rejected if the fit does not converge, and in five more cases. First: the error on
/// blocks of held-out rows does not fall. The error must fall in two of the blockings (or in all,
/// if there are fewer), and must not rise significantly in any. Second: chance could explain the
/// fall of -2 ln L. Third: a tolerance is given, and the held-out error without the effects is
/// within this tolerance. Fourth: one of several effects explains nothing beyond the others. Fifth:
/// a single effect leaves structure in the residuals, although another effect explains the data up
/// to the noise.
///
/// Throws std::invalid_argument if no id is given, for an unknown id (the message gives the nearest
/// ids), for an effect that the model already has, for an effect whose inputs the data lack (the
/// message gives their names), and for an effect that the data cannot separate from the base
/// parameters. For models that only approximate the readings (Subject::approximates()), use
/// loop/loop.h.
[[nodiscard]] AddResult add_by_noise(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::verdict
