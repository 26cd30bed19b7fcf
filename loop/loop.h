#pragma once

#include <span>
#include <string>

#include "loop/check.h"
#include "verdict/add.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"
#include "verdict/diagnose.h"

/// Runs calibrate, diagnose and add for both kinds of models. The misfit of most models is judged
/// against the noise of the readings (verdict/). A model that only approximates
/// (Subject::approximates()) is judged against the tolerance of the user (tolerance/).
namespace raceway::loop {

using verdict::compare;

/// Calls verdict::calibrate_by_noise() or tolerance::calibrate_approximation().
///
/// Throws std::invalid_argument like these functions. The function also throws
/// std::invalid_argument if profile-likelihood intervals are requested for a model that only
/// approximates, because the residuals of such a model are autocorrelated.
[[nodiscard]] verdict::Calibration calibrate(const fit::Subject& subject,
                                             const record::Record& record,
                                             const verdict::CalibrateOptions& options = {});

/// Calls verdict::diagnose_by_noise() or tolerance::diagnose_approximation().
///
/// Throws std::invalid_argument like these functions, and if options.tried_before is not between 0
/// and a million.
[[nodiscard]] verdict::Diagnosis diagnose(const fit::Subject& subject, const record::Record& record,
                                          const verdict::DiagnoseOptions& options = {});

/// Calls verdict::add_by_noise() or tolerance::add_approximation().
[[nodiscard]] verdict::AddResult add(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::loop
