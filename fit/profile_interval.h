#pragma once

#include <Eigen/Core>

#include "fit/response.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// Half width of the central 95 % interval of the normal distribution, in standard deviations. Its
/// square is the 95 % quantile of χ² with one degree of freedom.
constexpr double normal_95 = 1.959963984540;
constexpr double profile_rise = normal_95 * normal_95;

struct ProfileInterval {
  double lower = unset, upper = unset;
  /// True if the interval is open at this end. The end is then the bound of the parameter, or
  /// infinite if the parameter has no bound.
  bool open_lower = false, open_upper = false;
  int refits = 0;
};

/// 95 % interval of one parameter by profile likelihood, in the units of the file:
///
///   χ²(value) - χ²(fitted value) = 3.84 factor²
///
/// All other parameters are fitted again at every value [BatesWatts1988, ch. 6;
/// VenzonMoolgavkar1988]. The number 3.84 is the 95 % quantile of χ² with one degree of freedom.
/// `factor` widens the interval like the standard errors (Calibration::error_factor). For a model
/// that is linear in its parameters, the interval is value +- 1.96 factor std.
///
/// If χ² rises by less than 3.84 factor² up to a bound, this end of the interval is open and lies
/// at the bound. Without a bound, an open end is infinite. An end is NaN if the refits near it do
/// not converge. Each end is accurate to 1e-4 of its distance from the fitted value. An end needs
/// one refit if the model is linear, and about five if not.
[[nodiscard]] ProfileInterval profile_interval(const Response& response, const ResponseFit& fit,
                                               const Whitening& whitening,
                                               const Eigen::VectorXd& measured,
                                               std::size_t parameter, double factor = 1.0);

}  // namespace raceway::fit
