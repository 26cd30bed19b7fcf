#pragma once

#include <string>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

/// Functions for the sizes and errors of the candidates in a fit (Explanation). A candidate is an
/// effect that may be missing in the model, or a datum that may be wrong.
namespace raceway::verdict {

/// Returns the parameters of one candidate, as fitted in `e`. `member` is the index of the
/// candidate in Problem::candidates. The parameter names in the result do not contain the id of the
/// candidate. A value is plausible if it lies in the range seen in practice, widened by two
/// standard errors. For an effect, this range is first widened by a factor of three at both ends. A
/// value between the range and the value without influence (Parameter::neutral) is also plausible.
[[nodiscard]] std::vector<record::Parameter> sizes_of(const fit::Problem& problem,
                                                      const Explanation& e, std::size_t member);

/// Returns true if the sizes of all candidates are plausible.
[[nodiscard]] bool sizes_plausible(const fit::Problem& problem, const Explanation& e);

/// Returns the sizes of all candidates as text: "c = 3.1 +- 0.2 um".
[[nodiscard]] std::string size_text(const fit::Problem& problem, const Explanation& e);

/// Returns the corrected value of a wrong datum as text; empty if the candidate is an effect.
[[nodiscard]] std::string correction_text(const fit::Problem& problem, const Explanation& e,
                                          std::size_t member);

/// Returns false if a fitted value is more than `factor` times beyond the range seen in practice.
/// Two standard errors and values near the neutral value are allowed.
[[nodiscard]] bool is_plausible(const record::Parameter& p, double factor);
/// Returns the 95 % interval of the size of one candidate by profile likelihood. The interval is
/// NaN if the formula of the candidate is multiplied by fitted powers of the inputs
/// (Attribution::elastic()), because the exponents have no physical meaning.
[[nodiscard]] record::Interval size_interval(const Evidence& evidence, const Explanation& e,
                                             std::size_t member);

/// Returns the probability that random offsets between blocks of rows cause a misfit that looks
/// like the effect of one candidate:
///
///   P(F >= G / max(1, R / (B - 2)))
///
/// The random variable F has an F distribution with 1 and B - 2 degrees of freedom, for B blocks. G
/// is the decrease of the sum of the squared whitened residuals when the candidate is added. R is
/// the part of the remaining sum of squares that one offset for each block explains. The
/// probability is 0 if the candidate also improves a fit that contains one offset for each block.
/// The blocks are those that may be undeclared runs (RowOrder::new_block), or the declared runs if
/// the data do not show how much runs differ (NoiseModel::unknown_runs). With two blocks, the
/// probability is 1. The probability is also 1 if the record has one channel, and one step of all
/// readings from some block on has a gain of at least G - within_reach: if the levels of a setting
/// have the same order in two passes, a drift over time equals such a step together with an
/// influence of this setting. The result is NaN if there are no blocks, or if the formula of the
/// candidate is multiplied by fitted powers of the inputs (Attribution::elastic()).
[[nodiscard]] double chance_of_block_offsets(const Evidence& evidence, const Explanation& e,
                                             std::size_t member);

/// Returns the free parameters of the model. Their member `start` is the value in the fit without
/// candidates. Their members `value` and `std` are the value and the standard error in the fit `e`.
[[nodiscard]] std::vector<record::Parameter> base_with(const Evidence& evidence,
                                                       const Explanation& e);

/// Returns the free parameters of the model from the fit without candidates, with the standard
/// errors of calibrate().
[[nodiscard]] std::vector<record::Parameter> base_alone(const Evidence& evidence);

/// Returns the likelihood of the readings for a fit without or with candidates.
[[nodiscard]] fit::Likelihood likelihood_of(const Evidence& evidence, const fit::ResponseFit& fit);

/// Returns the correlation matrix of `parameters`, from a fit or from a covariance matrix. The
/// correlation is NaN for a parameter at a bound or without a covariance.
[[nodiscard]] Correlation correlation_of(const std::vector<record::Parameter>& parameters,
                                         const fit::ResponseFit& fit);
[[nodiscard]] Correlation correlation_of(const std::vector<record::Parameter>& parameters,
                                         const Eigen::MatrixXd& covariance);

/// Returns the held-out RMS error of each channel [SI], over all divisions of the rows into
/// held-out blocks (`blockings`). The result is empty if `blockings` is empty, or if the formula of
/// a candidate is multiplied by fitted powers of the inputs (Attribution::elastic()).
[[nodiscard]] std::vector<double> held_out(const Evidence& evidence, const fit::Response& response,
                                           const fit::ResponseFit& fit,
                                           const std::vector<fit::Blocking>& blockings);

/// Returns held-out RMS errors within the measured range [SI], like held_out(). In the blocks with
/// the lowest and the highest values of an input, a held-out prediction would be an extrapolation.
/// In these blocks, the function uses the error of the fit to all rows instead.
[[nodiscard]] std::vector<double> held_out_within_range(
    const Evidence& evidence, const fit::Response& response, const fit::ResponseFit& fit,
    const std::vector<fit::Blocking>& blockings);

/// Returns the readings that the fit `e` predicts, and the contributions of its effects. Call this
/// function only if no formula of a candidate is multiplied by fitted powers of the inputs
/// (Attribution::elastic()).
[[nodiscard]] ExplainedReadings explained_readings(const Evidence& evidence, const Explanation& e);

}  // namespace raceway::verdict
