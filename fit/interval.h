#pragma once

#include <Eigen/Core>

#include "fit/response.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// 95 % interval of one parameter by profile likelihood: where -2 ln L, all other parameters fitted
/// again, rises by 3.84 over its least value. Ends at a bound where it does not rise that far; NaN
/// where a fit on the way does not converge.
[[nodiscard]] Interval profile_interval(const Response& response, const ResponseFit& fit,
                                        const Whitening& whitening, const Eigen::VectorXd& measured,
                                        std::size_t parameter);

}  // namespace raceway::fit
