#pragma once

#include <span>
#include <string>

#include "loop/check.h"
#include "verdict/add.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"
#include "verdict/diagnose.h"

/// Functions calibrate(), diagnose() and add() for all models. For a bearing or shaft model, the
/// misfit is compared with the noise of the readings (verdict/). The residuals of a spindle model
/// or a correction are correlated in time (Subject::approximates()). For these models, the held-out
/// error is compared with the tolerance (tolerance/).
namespace raceway::loop {

using verdict::compare;

/// Fits the free parameters by verdict::calibrate_by_noise(), or by
/// tolerance::calibrate_approximation() for a spindle model or a correction.
///
/// Throws std::invalid_argument if the called function throws std::invalid_argument. For a spindle
/// model or a correction, calibrate() also throws it if options.profile is true, because intervals
/// by profile likelihood need residuals that are not correlated in time.
[[nodiscard]] verdict::Calibration calibrate(const fit::Subject& subject,
                                             const record::Record& record,
                                             const verdict::CalibrateOptions& options = {});

/// Finds the missing effect by verdict::diagnose_by_noise(), or by
/// tolerance::diagnose_approximation() for a spindle model or a correction.
///
/// Throws std::invalid_argument if the called function throws std::invalid_argument, or if
/// options.tried_before is not from 0 to 1 000 000. tried_before is the number of effects that
/// earlier diagnoses have tried with the same data.
[[nodiscard]] verdict::Diagnosis diagnose(const fit::Subject& subject, const record::Record& record,
                                          const verdict::DiagnoseOptions& options = {});

/// Adds effects and fits again by verdict::add_by_noise(), or by tolerance::add_approximation() for
/// a spindle model or a correction.
[[nodiscard]] verdict::AddResult add(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::loop
