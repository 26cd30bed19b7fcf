#pragma once

#include <memory>
#include <span>
#include <string>

#include "tolerance/approximation.h"
#include "verdict/add.h"
#include "verdict/diagnose.h"

/// Runs the loop for models that only approximate (Subject::approximates()). The question is
/// whether the missing effect exceeds the tolerance of the user on held-out parts of the record.
/// The residual of these models always exceeds the sensor noise and is correlated in time, so a
/// model would never pass a test against noise. Use these functions through loop/loop.h.
namespace raceway::tolerance {

/// Diagnoses a model on means over a minute or more:
///
///   refit -> held-out parts -> within the tolerance: no missing effect matters
///   each candidate -> one within the tolerance, together with all close to it
///   a fault that the record itself shows, if no single candidate is within the tolerance
///   pairs, if no single candidate is within -> a pair with at most 1/1.2 of the best single error
///   otherwise: effect-like (a candidate explains half of the mean square) or not-in-catalogue
///
/// The error with a single candidate also counts as within the tolerance if it exceeds the
/// tolerance by at most 1.645 standard errors, and if the candidate lowers the error by at least
/// the same factor. The relative standard error is 1/sqrt(2 T/30 min) for a record of duration T.
///
/// A candidate is close to the best one if its held-out error is at most a fifth larger, or if
/// lambda = T/(30 min) (r²/best² - 1) is below 20. A close candidate must also remove at least half
/// as much of the mean square error as the best one.
[[nodiscard]] verdict::Diagnosis diagnose_approximation(const fit::Subject& subject,
                                                        const record::Record& record,
                                                        const verdict::DiagnoseOptions& options);

/// Fits the free parameters to single rows, starting from the fit to means.
[[nodiscard]] verdict::Calibration calibrate_approximation(const fit::Subject& subject,
                                                           const record::Record& record);

[[nodiscard]] verdict::AddResult add_approximation(const fit::Subject& subject,
                                                   std::span<const std::string> ids,
                                                   const record::Record& record);

}  // namespace raceway::tolerance
