#pragma once

#include <memory>
#include <span>
#include <string>

#include "tolerance/approximation.h"
#include "verdict/add.h"
#include "verdict/diagnose.h"

/// Calibrates and diagnoses models that only approximate (Subject::approximates()), and adds
/// effects. The held-out error is compared with the tolerance of the user. The residual of these
/// models always exceeds the sensor noise and is correlated in time, so a model would never pass a
/// test against noise. Call these functions through loop/loop.h.
namespace raceway::tolerance {

/// Diagnoses a model on means over a minute or more:
///
///   refit -> held-out parts -> within the tolerance: no missing effect matters
///   each candidate -> one within the tolerance, together with all close to it
///   a fault that the record itself shows, if no single candidate is within the tolerance
///   pairs, if no single candidate is within -> a pair within the tolerance, with at most 1/1.2 of
///   the best single error
///   otherwise: effect-like (a candidate explains half of the mean square) or not-in-catalogue
///
/// The error with a single candidate is also within the tolerance if it is at most f times the
/// tolerance, and the candidate divides the error by at least f = 1 + 1.645/sqrt(2 T/30 min). T is
/// the duration of the longest run, and 1/sqrt(2 T/30 min) is the relative standard error of the
/// held-out error.
///
/// A candidate is close to the best one if its held-out error is at most a fifth larger, or if λ =
/// T/(30 min) (e²/b² - 1) is below 20. e is the held-out error with the candidate, and b with the
/// best candidate. A close candidate must also remove at least half as much of the mean square
/// error as the best one.
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
