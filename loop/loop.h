#pragma once

#include <span>
#include <string>

#include "loop/check.h"
#include "verdict/add.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"
#include "verdict/diagnose.h"

/// The questions of the loop, for a subject of either kind: one whose misfit is judged against the
/// noise of the readings (verdict/), and one that only approximates (Subject::approximates()) and
/// is judged against what the user tolerates (tolerance/).
namespace raceway::loop {

using verdict::compare;

/// verdict::calibrate_by_noise(), or tolerance::calibrate_approximation().
///
/// Throws std::invalid_argument as they do, and for intervals by profile likelihood of a subject
/// that only approximates: its residuals are autocorrelated.
[[nodiscard]] verdict::Calibration calibrate(const fit::Subject& subject,
                                             const record::Record& record,
                                             const verdict::CalibrateOptions& options = {});

/// verdict::diagnose_by_noise(), or tolerance::diagnose_approximation().
///
/// Throws std::invalid_argument as they do, and where options.tried_before is not from 0 to a
/// million.
[[nodiscard]] verdict::Diagnosis diagnose(const fit::Subject& subject, const record::Record& record,
                                          const verdict::DiagnoseOptions& options = {});

/// verdict::add_by_noise(), or tolerance::add_approximation().
[[nodiscard]] verdict::AddResult add(const fit::Subject& subject, std::span<const std::string> ids,
                                     const record::Record& record);

}  // namespace raceway::loop
