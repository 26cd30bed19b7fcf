#pragma once

#include <memory>
#include <span>
#include <string>

#include "tolerance/approximation.h"
#include "verdict/add.h"
#include "verdict/diagnose.h"

/// Calibrates and diagnoses spindle models and corrections (Subject::approximates()), and adds
/// effects to these models. The functions compare the held-out error with the tolerance. A
/// comparison with the sensor noise would reject every such model, because the residuals are larger
/// than this noise and correlated in time. Call these functions through loop/loop.h.
namespace raceway::tolerance {

/// Diagnoses a model. All fits use means of the readings over one minute or more. All errors in
/// this comment are held-out errors. The error of a fit is within the tolerance if the error of
/// every measured channel is within the tolerance of this channel. The diagnosis ends at the first
/// step that gives a verdict:
///
///   1. The model is fitted without candidates. If the error is within the tolerance, the verdict
///      is `nothing-missing`.
///   2. The model is fitted with each candidate alone, except the candidates driven by a column of
///      the record (Candidate::by_column). If the error is within the tolerance, the verdict is
///      `effect`, or `ambiguous` if other candidates are close to the best one.
///   3. If the record itself proves a fault of the measurement (Fault::certain), the verdict is
///      `effect-like`.
///   4. Step 2 is repeated with all candidates, including the candidates driven by a column.
///   5. The model is fitted with pairs of candidates. The verdict is several-effects if the error
///      is within the tolerance and at most 1/1.2 of the smallest error with a single candidate.
///   6. If a single candidate removes at least half of the mean square error, the verdict is
///      effect-like, otherwise not-in-catalogue.
///
/// From step 4 on, a candidate driven by a column must also reduce the error more than unrelated
/// columns do by chance (significance level 1 % for all columns together).
///
/// In steps 2 and 4, an error slightly above the tolerance also gives the verdict of the step,
/// because chance can explain the difference. Such an error is at most f times the tolerance, and
/// the candidate must reduce the error at least by the factor f:
///
///   f = 1 + 1.645/sqrt(2 T/30 min)
///
/// T is the duration of the longest run. Residuals are treated as independent if they are 30 min
/// apart. 1/sqrt(2 T/30 min) is then the relative standard error of the held-out error. 1.645 is
/// the 95 % quantile of the normal distribution.
///
/// The best candidate has the error b. Another candidate with the error e is close to the best one
/// if e/b is at most 1.2, or if its χ² is higher by less than 20. This difference of χ² is T/(30
/// min) (e²/b² - 1). The close candidate must also remove at least half as much of the mean square
/// error as the best one.
[[nodiscard]] verdict::Diagnosis diagnose_approximation(const fit::Subject& subject,
                                                        const record::Record& record,
                                                        const verdict::DiagnoseOptions& options);

/// Fits the free parameters to means of the readings over time. If the record has at most 20 000
/// rows, a second fit to the single rows follows.
[[nodiscard]] verdict::Calibration calibrate_approximation(const fit::Subject& subject,
                                                           const record::Record& record);

/// Adds the effects `ids` to the model and fits the free parameters again.
[[nodiscard]] verdict::AddResult add_approximation(const fit::Subject& subject,
                                                   std::span<const std::string> ids,
                                                   const record::Record& record);

}  // namespace raceway::tolerance
