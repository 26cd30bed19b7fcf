#pragma once

#include <string>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

/// Functions for the sizes and errors of the effects in a fit (Explanation).
namespace raceway::verdict {

/// Returns the fitted parameters of one candidate; their names do not contain its id. A value is
/// plausible if it lies in the range seen in practice. Both ends of this range are widened by a
/// factor of three (not for a wrong datum) and then by two standard errors. A value between this
/// range and the value without influence (Parameter::neutral) is also plausible.
[[nodiscard]] std::vector<record::Parameter> sizes_of(const fit::Problem& problem,
                                                      const Explanation& e, std::size_t member);

/// Returns true if the sizes of all candidates are plausible.
[[nodiscard]] bool sizes_plausible(const fit::Problem& problem, const Explanation& e);

/// Returns the sizes of all candidates as text: "c = 3.1 +- 0.2 um".
[[nodiscard]] std::string size_text(const fit::Problem& problem, const Explanation& e);

/// Returns the corrected value of a datum as text; empty for other candidates.
[[nodiscard]] std::string correction_text(const fit::Problem& problem, const Explanation& e,
                                          std::size_t member);

/// Returns the 95 % interval of the size of one candidate by profile likelihood. The interval is
/// NaN if the law is multiplied by powers of the inputs (Attribution::elastic()), because the
/// exponents have no physical meaning.
[[nodiscard]] record::Interval size_interval(const Evidence& evidence, const Explanation& e,
                                             std::size_t member);

/// Returns the probability that random offsets of blocks of rows follow one candidate as closely as
/// the observed offsets: P(F(1, B - 2) >= G / max(1, R / (B - 2))) for B blocks. G is the fall of
/// the sum of the squared whitened residuals when the candidate is added. R is the part of the
/// remaining sum of squares that one offset for each block explains. The probability is 0 if the
/// candidate is also visible within blocks. The result is NaN if there are no blocks that may be
/// undeclared runs (RowOrder::new_block), or if the law of the candidate is multiplied by powers of
/// the inputs (Attribution::elastic()).
[[nodiscard]] double chance_of_block_offsets(const Evidence& evidence, const Explanation& e,
                                             std::size_t member);

/// Returns the free parameters of the model. `start` is from the fit without candidates; `value`
/// and `std` are from the fit `e`.
[[nodiscard]] std::vector<record::Parameter> base_with(const Evidence& evidence,
                                                       const Explanation& e);

/// Returns the free parameters of the model from the fit without candidates, with the standard
/// errors of calibrate().
[[nodiscard]] std::vector<record::Parameter> base_alone(const Evidence& evidence);

/// Returns the likelihood of the readings for a fit without or with candidates.
[[nodiscard]] fit::Likelihood likelihood_of(const Evidence& evidence, const fit::ResponseFit& fit);

/// Returns the correlation matrix of these parameters, from their fit or from their covariance. The
/// correlation is NaN for a parameter at a bound or without a covariance.
[[nodiscard]] Correlation correlation_of(const std::vector<record::Parameter>& parameters,
                                         const fit::ResponseFit& fit);
[[nodiscard]] Correlation correlation_of(const std::vector<record::Parameter>& parameters,
                                         const Eigen::MatrixXd& covariance);

/// Returns the RMS error of each channel over the held-out blocks of all blockings [SI]. The result
/// is empty if `blockings` is empty, or if a law is multiplied by powers of the inputs
/// (Attribution::elastic()).
[[nodiscard]] std::vector<double> held_out(const Evidence& evidence, const fit::Response& response,
                                           const fit::ResponseFit& fit,
                                           const std::vector<fit::Blocking>& blockings);

/// Returns held-out RMS errors within the measured range [SI], like held_out(). For the blocks with
/// the lowest and the highest values of an input, a held-out prediction would be an extrapolation.
/// For these blocks, the function uses the error of the fit to all rows.
[[nodiscard]] std::vector<double> held_out_within_range(
    const Evidence& evidence, const fit::Response& response, const fit::ResponseFit& fit,
    const std::vector<fit::Blocking>& blockings);

/// Returns the readings that the fit `e` predicts, and the contributions of its effects. Call this
/// function only if no law is multiplied by powers of the inputs (Attribution::elastic()).
[[nodiscard]] ExplainedReadings explained_readings(const Evidence& evidence, const Explanation& e);

}  // namespace raceway::verdict
