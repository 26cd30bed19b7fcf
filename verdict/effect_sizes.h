#pragma once

#include <string>
#include <vector>

#include "verdict/attribution.h"
#include "verdict/diagnosis.h"

/// Sizes and errors of a fitted explanation.
namespace raceway::verdict {

/// Numbers of one member of an explanation, named without its id. A size is plausible within three
/// times the range met in practice, give or take two standard errors.
[[nodiscard]] std::vector<record::Parameter> sizes_of(const fit::Problem& problem,
                                                      const Explanation& e, std::size_t member);

/// True if the sizes of all members are plausible.
[[nodiscard]] bool sizes_plausible(const fit::Problem& problem, const Explanation& e);

/// Sizes of all members: "c = 3.1 +- 0.2 um".
[[nodiscard]] std::string size_text(const fit::Problem& problem, const Explanation& e);

/// Corrected value of a member that is a datum, in words; empty for others.
[[nodiscard]] std::string correction_text(const fit::Problem& problem, const Explanation& e,
                                          std::size_t member);

/// 95 % interval of the size of one member. A bent law has none: its exponents are no physics.
[[nodiscard]] record::Interval size_interval(const Evidence& evidence, const Explanation& e,
                                             std::size_t member);

/// Base parameters without (start) and with the explanation (value).
[[nodiscard]] std::vector<record::Parameter> base_with(const Evidence& evidence,
                                                       const Explanation& e);

/// Base parameters of the model without effects; errors as calibrate() gives them.
[[nodiscard]] std::vector<record::Parameter> base_alone(const Evidence& evidence);

/// Likelihood of the readings under a fit of the base, or of an explanation.
[[nodiscard]] fit::Likelihood likelihood_of(const Evidence& evidence, const fit::ResponseFit& fit);

/// Correlation of the estimates of a fit of these parameters, or of estimates with this covariance;
/// NaN where one has none.
[[nodiscard]] Correlation correlation_of(const std::vector<record::Parameter>& parameters,
                                         const fit::ResponseFit& fit);
[[nodiscard]] Correlation correlation_of(const std::vector<record::Parameter>& parameters,
                                         const Eigen::MatrixXd& covariance);

/// Root mean square error over the blocks that the fit did not see, in all blockings, of each
/// channel [SI]; empty for a bent law and without blockings.
[[nodiscard]] std::vector<double> held_out(const Evidence& evidence, const fit::Response& response,
                                           const fit::ResponseFit& fit,
                                           const std::vector<fit::Blocking>& blockings);

/// Held-out errors within the measured range: an outermost block of an ordered blocking, where the
/// others only extrapolate, counts with its error in the fit.
[[nodiscard]] std::vector<double> held_out_within_range(
    const Evidence& evidence, const fit::Response& response, const fit::ResponseFit& fit,
    const std::vector<fit::Blocking>& blockings);

/// Readings of an explanation that is not a bent law, and their parts; by observation.
[[nodiscard]] ExplainedReadings explained_readings(const Evidence& evidence, const Explanation& e);

}  // namespace raceway::verdict
