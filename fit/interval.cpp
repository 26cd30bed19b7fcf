#include "fit/interval.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace raceway::fit {

namespace {

constexpr double rise = 3.841459;  // 95 % of chi-squared with one degree of freedom
constexpr int most_steps = 30;

/// The response with one parameter held at a value.
Response held(const Response& response, std::size_t parameter, double value) {
  const auto at = static_cast<Eigen::Index>(parameter);
  Response reduced;
  reduced.parameters = response.parameters;
  reduced.parameters.erase(reduced.parameters.begin() + at);
  const auto whole = [at, value](const Eigen::VectorXd& x) {
    Eigen::VectorXd all(x.size() + 1);
    all << x.head(at), value, x.tail(x.size() - at);
    return all;
  };
  reduced.readings = [&response, whole](const Eigen::VectorXd& x) { return response.at(whole(x)); };
  if (response.affine) {
    const Eigen::MatrixXd& slope = response.affine->slope;
    Response::Affine form;
    form.constant = response.affine->constant + slope.col(at) * value;
    form.slope.resize(slope.rows(), slope.cols() - 1);
    form.slope << slope.leftCols(at), slope.rightCols(slope.cols() - 1 - at);
    reduced.affine = std::move(form);
  }
  return reduced;
}

}  // namespace

Interval profile_interval(const Response& response, const ResponseFit& fit,
                          const Whitening& whitening, const Eigen::VectorXd& measured,
                          std::size_t parameter) {
  const auto at = static_cast<Eigen::Index>(parameter);
  const Parameter& p = response.parameters[parameter];
  const double best = fit.values[at];
  Eigen::VectorXd others(fit.values.size() - 1);
  others << fit.values.head(at), fit.values.tail(others.size() - at);
  const auto excess = [&](double value) {
    const Response reduced = held(response, parameter, value);
    const ResponseFit refit = fit_response(reduced, whitening, measured, {others, 0.95 * others});
    return refit.converged ? refit.misfit - fit.misfit - rise : unset;
  };
  const double step = std::isfinite(fit.standard_errors[at]) && fit.standard_errors[at] > 0.0
                          ? 1.96 * fit.standard_errors[at]
                          : 0.1 * p.scale;
  const auto end = [&](double direction) {
    const double bound = direction < 0.0 ? p.lower : p.upper;
    double inside = best, outside = best, below = -rise, above = unset;
    for (int k = 0; k < most_steps; ++k) {
      outside = best + direction * step * std::pow(1.5, k);
      const bool stop = direction * (outside - bound) >= 0.0;
      if (stop) outside = bound;
      above = outside == best ? -rise : excess(outside);
      if (!(above < 0.0)) break;
      if (stop) return bound;
      inside = outside;
      below = above;
    }
    if (!(above >= 0.0)) return unset;
    std::uintmax_t steps = most_steps;
    const auto [a, b] = boost::math::tools::toms748_solve(
        excess, std::min(inside, outside), std::max(inside, outside),
        direction > 0.0 ? below : above, direction > 0.0 ? above : below,
        boost::math::tools::eps_tolerance<double>(12), steps);
    return 0.5 * (a + b);
  };
  return {end(-1.0), end(1.0)};
}

}  // namespace raceway::fit
