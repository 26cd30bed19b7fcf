#pragma once

#include <Eigen/Core>

#include "fit/response.h"
#include "fit/whitening.h"

namespace raceway::fit {

/// Half width of the central 95 % interval of the normal distribution, in standard deviations. The
/// square of this number, `profile_rise`, is the 95 % quantile of χ² with one degree of freedom.
constexpr double normal_95 = 1.959963984540;
constexpr double profile_rise = normal_95 * normal_95;

/// Result of profile_interval().
struct ProfileInterval {
  double lower = unset, upper = unset;
  /// True if χ² rises too little to limit the interval at its lower or upper end. The open end is
  /// the bound of the parameter, or infinite if the parameter has no bound.
  bool open_lower = false, open_upper = false;
  int refits = 0;  ///< number of fits that the calculation needed
};

/// Returns the 95 % interval of one parameter by profile likelihood, in the unit of the model file.
/// An end of the interval is a value for which
///
///   χ²(value) - χ²(fitted value) = 3.84 factor²
///
/// All other parameters are fitted again at every value [BatesWatts1988, ch. 6;
/// VenzonMoolgavkar1988]. 3.84 is the 95 % quantile of χ² with one degree of freedom. `factor`
/// widens the interval in the same way as the standard errors (Calibration::error_factor). If the
/// model is linear in its parameters, the interval is fitted value +- 1.96 factor std, where std is
/// the standard error.
///
/// If χ² rises by less than 3.84 factor² up to a bound, the interval is open and ends at the bound.
/// Without a bound, an open end is infinite. An end is NaN if the fits near this end do not
/// converge. Each end is accurate to 1e-4 of its distance from the fitted value. Each end needs
/// about one additional fit for a linear model, and about five fits for other models.
[[nodiscard]] ProfileInterval profile_interval(const Response& response, const ResponseFit& fit,
                                               const Whitening& whitening,
                                               const Eigen::VectorXd& measured,
                                               std::size_t parameter, double factor = 1.0);

}  // namespace raceway::fit
