#pragma once

#include <memory>
#include <span>
#include <string>

#include "tolerance/approximation.h"
#include "verdict/add.h"
#include "verdict/diagnose.h"

/// The loop for subjects that only approximate (Subject::approximates()): is what is missing larger
/// than what the user tolerates, on parts of the record that no fit saw? What they leave is always
/// larger than the noise of the sensor and follows the rows before it, so that no test against
/// noise would ever be passed. Called by loop/loop.h.
namespace raceway::tolerance {

/// Verdict on the means of a minute or more:
///
///   refit -> held out, part by part -> within the tolerance: nothing is missing that matters
///   each candidate -> one within the tolerance, with all that come near it
///   a fault that the record shows of itself, where no single one is within
///   pairs, where no single one is within -> one that gains a fifth more
///   otherwise like the one that takes half of the mean square, or in no catalogue
///
/// An error of a single one that is not told from the tolerance (1.645 of its standard error,
/// 1/sqrt(2 T/30 min)) is within.
///
/// Near is what errs at most a fifth more, or is not told from the best by
/// lambda = T/(30 min) (r²/best² - 1) of at least 20, errors on parts held out, and takes half of
/// what the best takes.
[[nodiscard]] verdict::Diagnosis diagnose_approximation(const fit::Subject& subject,
                                                        const record::Record& record,
                                                        const verdict::DiagnoseOptions& options);

/// Free parameters fitted to single rows, begun where the means led.
[[nodiscard]] verdict::Calibration calibrate_approximation(const fit::Subject& subject,
                                                           const record::Record& record);

[[nodiscard]] verdict::AddResult add_approximation(const fit::Subject& subject,
                                                   std::span<const std::string> ids,
                                                   const record::Record& record);

}  // namespace raceway::tolerance
