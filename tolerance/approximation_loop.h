#pragma once

#include <memory>
#include <span>
#include <string>

#include "tolerance/approximation.h"
#include "verdict/add.h"
#include "verdict/diagnose.h"

/// Calibrates and diagnoses models of displacements and temperatures over time
/// (Subject::approximates()), and adds effects to them. The held-out error is compared with the
/// tolerance of the user. The residual of these models always exceeds the sensor noise and is
/// correlated in time, so a model would never pass a test against noise. Call these functions
/// through loop/loop.h.
namespace raceway::tolerance {

/// Diagnoses a model on means over a minute or more. All errors below are held-out errors. An error
/// is within the tolerance if every measured channel is within its tolerance.
///
///   1. Refit without candidates. Verdict for an error within the tolerance: nothing-missing.
///   2. Refit with each candidate alone. Verdict for an error within the tolerance: effect (or
///      ambiguous), with the best candidate and all candidates close to it.
///   3. The record itself proves a fault of the measurement (fit::Fault). Verdict: effect-like.
///   4. Refit with pairs of candidates. Verdict for an error that is within the tolerance and at
///      most 1/1.2 of the smallest error with a single candidate: several-effects.
///   5. A single candidate removes at least half of the mean square error. Verdict: effect-like.
///      Otherwise: not-in-catalogue.
///
/// The diagnosis ends at the first step that gives a verdict. Candidates driven by a column of the
/// record (Candidate::by_column) are accepted only in steps 4 and 5.
///
/// In step 2, an error beyond the tolerance is also accepted if it is at most f times the
/// tolerance, and if the candidate divides the error by at least f = 1 + 1.645/sqrt(2 T/30 min). T
/// is the duration of the longest run, and 1/sqrt(2 T/30 min) is the relative standard error of the
/// held-out error.
///
/// A candidate is close to the best one if its held-out error is at most a fifth larger, or if λ =
/// T/(30 min) (e²/b² - 1) is below 20. e is the held-out error with the candidate, and b the
/// held-out error with the best candidate. A close candidate must also remove at least half as much
/// of the mean square error as the best one.
[[nodiscard]] verdict::Diagnosis diagnose_approximation(const fit::Subject& subject,
                                                        const record::Record& record,
                                                        const verdict::DiagnoseOptions& options);

/// Fits the free parameters to means, and then to single rows if there are at most 20 000.
[[nodiscard]] verdict::Calibration calibrate_approximation(const fit::Subject& subject,
                                                           const record::Record& record);

[[nodiscard]] verdict::AddResult add_approximation(const fit::Subject& subject,
                                                   std::span<const std::string> ids,
                                                   const record::Record& record);

}  // namespace raceway::tolerance
