#pragma once

#include <string>
#include <vector>

#include "verdict/attribution.h"

/// Functions that calibrate other base models for diagnose() and add().
namespace raceway::verdict {

/// Another base model, calibrated to the readings of a diagnosis with the noise of this diagnosis.
struct CalibratedBase {
  fit::OtherBase base{};
  /// Fit without candidates. Its parameters are the free parameters of the other base model. The
  /// gain is the fall of -2 ln L relative to the given model after a refit, minus ln N for each
  /// additional free parameter, with N readings.
  Explanation explanation{};
  std::string not_testable{};  ///< reason if the base model cannot be tested; empty if it can
};

[[nodiscard]] CalibratedBase calibrate_other_base(const Evidence& evidence, fit::OtherBase base);

/// Calibrates all other base models (Subject::other_bases()). Laws with fitted exponents
/// (OtherBase::fitted_form) follow all other laws. Each of these two groups is sorted by gain,
/// largest first, and models that cannot be tested come last in their group.
[[nodiscard]] std::vector<CalibratedBase> calibrate_other_bases(const Evidence& evidence);

/// Returns the model with this base law and the calibrated values.
[[nodiscard]] std::shared_ptr<const fit::Subject> fitted_subject(const CalibratedBase& found);

}  // namespace raceway::verdict
