#pragma once

#include <Eigen/Core>

#include "fit/response.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// 95 % of the normal distribution lie within this many standard deviations; its square belongs to
/// χ² with one degree of freedom.
constexpr double normal_95 = 1.959963984540;
constexpr double profile_rise = normal_95 * normal_95;

struct ProfileInterval {
  double lower = unset, upper = unset;
  /// The bound stands there, and what is beyond was not looked at.
  bool open_lower = false, open_upper = false;
  int refits = 0;
};

/// 95 % interval of one parameter by profile likelihood, in units of the file:
///
///   χ²(value) - χ²(least) = 3.84 factor²
///
/// with all other parameters fitted again at every value [BatesWatts1988, ch. 6;
/// VenzonMoolgavkar1988]. 3.84 belongs to χ² with one degree of freedom; `factor`, by which
/// standard errors are widened, is the root of the reduced χ² where the size of the noise is
/// itself taken from the misfit. Of a model that is linear in its parameters it is value +- 1.96
/// factor std.
///
/// Ends at a bound, and is open there, where it does not rise that far; an open end without a bound
/// is infinite. NaN where fits on the way do not converge. An end is within 1e-4 of its
/// distance from the value; it takes one refit of a linear model and some five of others.
[[nodiscard]] ProfileInterval profile_interval(const Response& response, const ResponseFit& fit,
                                               const Whitening& whitening,
                                               const Eigen::VectorXd& measured,
                                               std::size_t parameter, double factor = 1.0);

}  // namespace raceway::fit
