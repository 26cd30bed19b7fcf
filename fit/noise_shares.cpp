#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fit/detail/noise_search.h"

namespace raceway::fit {

namespace {

constexpr double worth_an_input = 3.84;      // of -2 ln L: 5 % level of one parameter
constexpr double rounding_of_misfit = 1e-6;  // of -2 ln L

/// Lower bounds of -2 ln L for many variances of independent readings, from fits with some of them.
///
///   -2 ln L = f ln q + Σ ln v_i + ln det XᵀV⁻¹X        q = min over β of Σ (y - Xβ)_i² / v_i
///
/// A fit with other variances u and residuals r = y - Xβ bounds q by the inequality of Cauchy and
/// Schwarz, q(v) >= q(u)² / Σ v_i (r_i/u_i)². The last term is convex in ln v, so it is not below
/// its tangent; the slopes of the tangent are the leverages with a minus sign.
class LowerBounds {
 public:
  /// The tangent belongs to this fit with the variances of column `at`.
  LowerBounds(const Variances& variances, const RestrictedFit& fit, std::size_t at)
      : variances_(variances), freedom_(fit.freedom()) {
    const Eigen::Index count = variances.shares.cols();
    const Eigen::VectorXd free = (1.0 - fit.leverage().array()).matrix();
    rest_.resize(count);
    for (Eigen::Index k = 0; k < count; ++k)
      rest_[k] = free.dot(variances[k].array().log().matrix());
    rest_ +=
        fit.misfit() - freedom_ * std::log(fit.square()) - rest_[static_cast<Eigen::Index>(at)];
    log_square_ = Eigen::ArrayXd::Constant(count, -std::numeric_limits<double>::infinity());
  }

  /// Raises the bounds by what a fit with the variances of column `at` shows.
  void learn(const RestrictedFit& fit, std::size_t at) {
    const Eigen::VectorXd pull =
        (fit.residual().array().square() / variances_[static_cast<Eigen::Index>(at)].array())
            .matrix();  // (r_i/u_i)²
    const Eigen::ArrayXd sum =
        variances_.shares.transpose() * (variances_.parts.transpose() * pull);
    log_square_ = log_square_.max(2.0 * std::log(fit.square()) - sum.log());
  }

  [[nodiscard]] double operator[](std::size_t column) const {
    const auto k = static_cast<Eigen::Index>(column);
    return freedom_ * log_square_[k] + rest_[k];
  }

 private:
  const Variances& variances_;
  double freedom_;
  Eigen::ArrayXd rest_, log_square_;
};

}  // namespace

std::vector<NoiseSearch::Shares> NoiseSearch::all_shares() const {
  std::vector<Shares> list;
  for (const double input : {0.0, 0.1, 0.25, 0.45, 0.7, 0.9}) {
    if (input > 0.0 && parts_.slope.size() == 0) break;
    for (const double s : {1.0, 0.998, 0.99, 0.97, 0.93, 0.85, 0.7, 0.5, 0.25, 0.1, 0.0})
      list.push_back({.relative = s * (1.0 - input), .input = input});
  }
  return list;
}

double NoiseSearch::cost(const Shares& shares) {
  // Fewer parts are preferred unless a mixture is clearly better. Scatter of an input is not
  // declared by the record, so it has to gain more.
  return static_cast<double>(shares.parts() - 1) + (shares.input > 0.0 ? worth_an_input : 0.0);
}

double NoiseSearch::find_shares(const std::vector<Shares>& list) {
  std::vector<double> costs;
  for (const Shares& s : list) costs.push_back(cost(s));
  const std::vector<double> value = values(list, costs, infinity);
  const auto best = std::min_element(value.begin(), value.end());
  if (best == value.end() || !(*best < infinity)) return infinity;
  shares_ = list[static_cast<std::size_t>(best - value.begin())];
  return *best;
}

std::vector<NoiseSearch::Shares> NoiseSearch::shares_below(double limit) const {
  const std::vector<Shares> list = all_shares();
  const std::vector<double> value = values(list, {}, limit);
  std::vector<Shares> found;
  for (std::size_t k = 0; k < list.size(); ++k)
    if (value[k] < limit) found.push_back(list[k]);
  return found;
}

std::vector<double> NoiseSearch::values(const std::vector<Shares>& list,
                                        const std::vector<double>& costs, double limit) const {
  std::vector<double> value(list.size(), infinity);
  const auto cost_of = [&](std::size_t k) { return costs.empty() ? 0.0 : costs[k]; };
  const auto fit = [&](std::size_t k) {
    RestrictedFit found = restricted(noise_.correlation, noise_.run_share, list[k]);
    value[k] = std::fmin(found.misfit() + cost_of(k), infinity);  // infinite also for NaN
    return found;
  };
  if (noise_.has_memory()) {
    for (std::size_t k = 0; k < list.size(); ++k) fit(k);
    return value;
  }
  const Variances variances = variances_of(list);
  std::optional<LowerBounds> bounds;
  std::vector<bool> known(list.size(), false);
  // From the present shares on, always the most promising of those that are left.
  std::size_t next = list.size() / 2;
  for (std::size_t k = 0; k < list.size(); ++k)
    if (list[k].relative == shares_.relative && list[k].input == shares_.input) next = k;
  while (next < list.size()) {
    const RestrictedFit found = fit(next);
    known[next] = true;
    if (!costs.empty()) limit = std::min(limit, value[next]);
    if (std::isfinite(found.misfit())) {
      if (!bounds) bounds.emplace(variances, found, next);
      bounds->learn(found, next);
    }
    next = list.size();
    double least = infinity;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const double bound = bounds ? (*bounds)[k] + cost_of(k) - rounding_of_misfit : -infinity;
      if (known[k] || bound > limit || (next < list.size() && !(bound < least))) continue;
      next = k;
      least = bound;
    }
  }
  return value;
}

Variances NoiseSearch::variances_of(const std::vector<Shares>& list) const {
  const Parts some = some_parts();
  const bool scatters = some.slope.size() > 0;
  Variances v{.parts = Eigen::MatrixXd(some.reading.size(), scatters ? 3 : 2),
              .shares = Eigen::MatrixXd(scatters ? 3 : 2, static_cast<Eigen::Index>(list.size()))};
  v.parts.leftCols(2) << some.reading, some.own;
  if (scatters) v.parts.col(2) = some.slope;
  v.parts = (stretched()(some_).asDiagonal() * v.parts).array().square().matrix();
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    v.shares.col(column).head(2) << list[k].relative, list[k].absolute();
    if (scatters) v.shares(2, column) = list[k].input;
  }
  return v;
}

}  // namespace raceway::fit
