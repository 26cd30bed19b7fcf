#pragma once

#include <span>
#include <string>

#include "loop/check.h"
#include "verdict/add.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"
#include "verdict/diagnose.h"

/// Runs calibrate, diagnose and add for all models. For a bearing or shaft model, the misfit is
/// compared with the noise of the readings (verdict/). For a spindle model or a correction, whose
/// residuals stay correlated in time (Subject::approximates()), the held-out error is compared with
/// the tolerance of the user (tolerance/).
namespace raceway::loop {

using verdict::compare;

/// Fits the free parameters by verdict::calibrate_by_noise(), or by
/// tolerance::calibrate_approximation() for a spindle model or a correction.
///
/// Throws std::invalid_argument like these functions, and if profile-likelihood intervals are
/// requested for a spindle model or a correction, because its residuals are correlated in time.
[[nodiscard]] verdict::Calibration calibrate(const fit::Subject& subject,
                                             const record::Record& record,
                                             const verdict::CalibrateOptions& options = {});

/// Finds the missing effect by verdict::diagnose_by_noise(), or by
/// tolerance::diagnose_approximation() for a spindle model or a correction.
///
/// Throws std::invalid_argument like these functions, and if options.tried_before, the number of
/// effects tried earlier on these data, is not between 0 and a million.
[[nodiscard]] verdict::Diagnosis diagnose(const fit::Subject& subject, const record::Record& record,
                                          const verdict::DiagnoseOptions& options = {});

/// Adds effects and fits again by verdict::add_by_noise(), or by tolerance::add_approximation() for
/// a spindle model or a correction.
[[nodiscard]] verdict::AddResult add(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::loop
