#include "fit/hold_out.h"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>

#include "algebra/detail/decompositions.h"

namespace raceway::fit {

namespace {

constexpr int bootstraps = 1000;

}  // namespace

std::vector<Blocking> blocks_of_observations(const Judged& subject, const Record& record,
                                             const Observations& observed) {
  std::vector<Blocking> result = subject.blockings(record);
  for (Blocking& blocking : result) {
    const std::vector<int> by_row = std::move(blocking.block);
    blocking.block.clear();
    for (const std::size_t row : observed.row) blocking.block.push_back(by_row[row]);
  }
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
    const Eigen::MatrixXd columns = w.asDiagonal() * tangent(in, Eigen::all);
    Eigen::VectorXd step = algebra::least_squares(columns, w.cwiseProduct(rest(in)));
    // A refit that leaves the bounds stops there.
    for (std::size_t j = 0; j < free.size(); ++j) {
      const Parameter& p = response.parameters[static_cast<std::size_t>(free[j])];
      double& s = step[static_cast<Eigen::Index>(j)];
      s = std::clamp(fit.values[free[j]] + s, p.lower, p.upper) - fit.values[free[j]];
    }
    for (const Eigen::Index i : out) errors[i] = rest[i] - tangent.row(i).dot(step);
  }
  return errors;
}

HoldOut compare_held_out(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                         const Eigen::VectorXd& std, const Observations& observed,
                         const Blocking& blocking) {
  HoldOut result{.variable = blocking.variable};
  const auto rows = static_cast<double>(before.size());
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    result.rmse_before.push_back(rms(observed.of(c, before)));
    result.rmse_after.push_back(rms(observed.of(c, after)));
  }
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

std::vector<double> rms_over(const std::vector<HoldOut>& results,
                             std::vector<double> HoldOut::*rmse) {
  if (results.empty()) return {};
  std::vector<double> sum((results.front().*rmse).size(), 0.0);
  for (const HoldOut& h : results)
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += (h.*rmse)[c] * (h.*rmse)[c];
  for (double& s : sum) s = std::sqrt(s / static_cast<double>(results.size()));
  return sum;
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
