#include "fit/hold_out.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>

namespace raceway::fit {

namespace {

constexpr int most_blocks = 8;
constexpr int bootstraps = 1000;

/// Levels of a variable, merged to at most eight ranges; no blocks where it does not vary.
Blocking levels(std::string variable, const std::vector<double>& values, double width) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> first{sorted.front()};  // lowest value of each level
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i] > sorted[i - 1] + width) first.push_back(sorted[i]);
  if (first.size() > static_cast<std::size_t>(most_blocks) || first.size() < 2) {
    const bool many = first.size() >= 2 || sorted.back() - sorted.front() > 3.0 * width;
    first.assign(1, sorted.front());
    for (int k = 1; many && k < most_blocks; ++k) {
      const double value = sorted[sorted.size() * static_cast<std::size_t>(k) / most_blocks];
      if (value > first.back()) first.push_back(value);
    }
  }
  Blocking result{.variable = std::move(variable)};
  for (const double value : values)
    result.block.push_back(
        static_cast<int>(std::upper_bound(first.begin(), first.end(), value) - first.begin()) - 1);
  result.blocks = static_cast<int>(first.size());
  return result;
}

}  // namespace

std::vector<Blocking> blockings(const DataSet& data) {
  std::vector<Blocking> result;
  const auto add = [&](const char* name, double relative, double absolute, auto value) {
    std::vector<double> values;
    double largest = 0.0;
    for (const Row& row : data.rows) {
      values.push_back(value(row));
      largest = std::max(largest, std::abs(values.back()));
    }
    Blocking blocking = levels(name, values, relative * largest + absolute);
    if (blocking.blocks >= 2) result.push_back(std::move(blocking));
  };
  add("speed", 5e-3, 0.0, [](const Row& r) { return r.point.speed; });
  add("axial_load", 5e-3, 0.0, [](const Row& r) { return r.point.axial_load; });
  add("temperature", 0.0, 1.0, [](const Row& r) { return r.point.temperature; });
  add("preload", 5e-3, 0.0, [](const Row& r) { return std::isnan(r.preload) ? 0.0 : r.preload; });
  if (result.size() < 3) add("run", 0.0, 0.5, [](const Row& r) { return 1.0 * r.run; });
  return result;
}

Eigen::VectorXd held_out_errors(const Response& response, const ResponseFit& fit,
                                const Eigen::VectorXd& measured, const Eigen::VectorXd& std,
                                const Blocking& blocking) {
  const Eigen::VectorXd weight = std.cwiseInverse();
  std::vector<Eigen::Index> free;
  for (std::size_t k = 0; k < fit.at_bound.size(); ++k)
    if (!fit.at_bound[k]) free.push_back(static_cast<Eigen::Index>(k));
  const Eigen::MatrixXd tangent = fit.slope(Eigen::all, free);
  const Eigen::VectorXd rest = measured - fit.prediction;
  Eigen::VectorXd errors = rest;
  for (int b = 0; b < blocking.blocks; ++b) {
    std::vector<Eigen::Index> in, out;
    for (std::size_t i = 0; i < blocking.block.size(); ++i)
      (blocking.block[i] == b ? out : in).push_back(static_cast<Eigen::Index>(i));
    if (in.size() <= free.size() || free.empty()) continue;
    const Eigen::VectorXd w = weight(in);
    Eigen::MatrixXd columns = w.asDiagonal() * tangent(in, Eigen::all);
    Eigen::VectorXd step =
        Eigen::MatrixXd(columns).colPivHouseholderQr().solve(w.cwiseProduct(rest(in)));
    // A refit that leaves the bounds stops there.
    for (std::size_t j = 0; j < free.size(); ++j) {
      const FitParameter& p = response.parameters[static_cast<std::size_t>(free[j])];
      double& s = step[static_cast<Eigen::Index>(j)];
      s = std::clamp(fit.values[free[j]] + s, p.lower, p.upper) - fit.values[free[j]];
    }
    for (const Eigen::Index i : out) errors[i] = rest[i] - tangent.row(i).dot(step);
  }
  return errors;
}

HoldOut compare_held_out(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                         const Eigen::VectorXd& std, const Blocking& blocking) {
  HoldOut result{.variable = blocking.variable};
  const auto rows = static_cast<double>(before.size());
  result.rmse_before = before.norm() / std::sqrt(rows);
  result.rmse_after = after.norm() / std::sqrt(rows);
  std::vector<double> sum(static_cast<std::size_t>(blocking.blocks), 0.0);
  std::vector<double> count(sum.size(), 0.0);
  for (Eigen::Index i = 0; i < before.size(); ++i) {
    const auto b = static_cast<std::size_t>(blocking.block[static_cast<std::size_t>(i)]);
    sum[b] += (before[i] * before[i] - after[i] * after[i]) / (std[i] * std[i]);
    count[b] += 1.0;
  }
  double all = 0.0;
  for (const double s : sum) all += s;
  result.improvement = all / rows;
  boost::random::mt19937 engine(20210305);
  boost::random::uniform_int_distribution<std::size_t> any(0, sum.size() - 1);
  std::vector<double> means;
  for (int k = 0; k < bootstraps; ++k) {
    double total = 0.0, n = 0.0;
    for (std::size_t b = 0; b < sum.size(); ++b) {
      const std::size_t chosen = any(engine);
      total += sum[chosen];
      n += count[chosen];
    }
    means.push_back(total / std::max(1.0, n));
  }
  std::sort(means.begin(), means.end());
  result.lower = means[static_cast<std::size_t>(0.025 * bootstraps)];
  result.upper = means[static_cast<std::size_t>(0.975 * bootstraps)];
  return result;
}

bool confirmed(const std::vector<HoldOut>& results) {
  int better = 0;
  for (const HoldOut& r : results) {
    if (r.worse()) return false;
    if (r.better()) ++better;
  }
  return better >= std::min<int>(2, static_cast<int>(results.size()));
}

}  // namespace raceway::fit
