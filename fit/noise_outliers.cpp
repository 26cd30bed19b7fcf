#include <algorithm>
#include <cmath>

#include "fit/detail/noise_search.h"
#include "fit/distributions.h"
#include "record/median.h"

namespace raceway::fit {

namespace {

constexpr double outlier_share = 4.65e-4;  // of a normal law beyond 3.5 standard deviations
constexpr int robust_steps = 12;
constexpr double biweight = 4.685;     // robust deviations at which a reading has no weight
constexpr double most_outliers = 0.2;  // of the rows
constexpr double gathered = 0.05;      // p of outliers that gather at one level by chance
constexpr std::size_t fewest_gathered = 3;

/// Robust standard deviations beyond which a residual is an outlier: as rare as 3.5 of a known
/// deviation, by Student's law of that many degrees of freedom. A median is as good as a mean over
/// 37 % of them.
double outlier_limit(double degrees_of_freedom) {
  return t_exceeded_with(std::max(2.0, 0.37 * degrees_of_freedom), outlier_share / 2.0);
}

/// Chance of so many hits or more in so many trials.
double binomial_at_least(double hits, double trials, double share) {
  double sum = 0.0;
  for (double k = hits; k <= trials; k += 1.0)
    sum +=
        std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) - std::lgamma(trials - k + 1.0) +
                 k * std::log(share) + (trials - k) * std::log1p(-std::min(share, 1.0 - 1e-12)));
  return sum;
}

}  // namespace

void NoiseSearch::spare_levels() {
  std::vector<bool> far(static_cast<std::size_t>(rows_));
  double all = 0.0;
  for (Eigen::Index i = 0; i < rows_; ++i) {
    far[static_cast<std::size_t>(i)] = widening_[i] > 1.0;
    all += widening_[i] > 1.0 ? 1.0 : 0.0;
  }
  for (const std::vector<std::size_t>& level : readings_.levels) {
    const std::size_t count = 1 + *std::max_element(level.begin(), level.end());
    for (std::size_t k = 0; k < count; ++k) {
      double rows = 0.0, here = 0.0;
      for (std::size_t i = 0; i < level.size(); ++i)
        if (level[i] == k) {
          rows += 1.0;
          here += far[i] ? 1.0 : 0.0;
        }
      if (here < static_cast<double>(fewest_gathered) ||
          binomial_at_least(here, all, rows / static_cast<double>(rows_)) *
                  static_cast<double>(count) >
              gathered)
        continue;
      for (std::size_t i = 0; i < level.size(); ++i)
        if (level[i] == k) widening_[static_cast<Eigen::Index>(i)] = 1.0;
    }
  }
}

void NoiseSearch::suspect_outliers() {
  const Eigen::Index some = std::min(columns_.cols(), rows_ / 6);
  const Eigen::VectorXd scale = shape(shares_, parts_, stretched()).cwiseInverse();
  const Eigen::MatrixXd x = scale.asDiagonal() * columns_.leftCols(some);
  const Eigen::VectorXd y = scale.cwiseProduct(readings_.measured);
  Eigen::ArrayXd weight = Eigen::ArrayXd::Ones(rows_), deviation;
  double robust = 0.0;
  for (int k = 0; k < robust_steps; ++k) {
    const Eigen::VectorXd root = weight.sqrt().matrix();
    const Regression r = regress(root.asDiagonal() * x, root.cwiseProduct(y));
    deviation = (r.residual.cwiseQuotient(root).array() / r.freedom.array().sqrt()).abs();
    robust = 1.4826 * record::median({deviation.begin(), deviation.end()});
    if (!(robust > 0.0)) return;
    const Eigen::ArrayXd far = deviation / robust;
    if (k < robust_steps / 2)
      weight = far.cwiseMax(1.0).inverse();
    else
      weight = (1.0 - (far / biweight).square()).cwiseMax(0.03).square();
  }
  const double limit = outlier_limit(static_cast<double>(rows_ - some));
  for (Eigen::Index i = 0; i < rows_; ++i)
    if (const double far = deviation[i] / robust; far > limit) widening_[i] = far * far / limit;
  // So many are no outliers, but what so few columns cannot follow.
  if (static_cast<double>((widening_.array() > 1.0).count()) >
      most_outliers * static_cast<double>(rows_))
    widening_.setOnes();
  spare_levels();
}

void NoiseSearch::find_outliers() {
  const Whitening independent(shape(shares_, parts_, stretched()), {}, 0.0, 0.0);
  const Regression regression = regress(independent(columns_), independent(readings_.measured));
  const Eigen::VectorXd reading =
      regression.fitted.cwiseProduct(independent.std()).cwiseAbs().cwiseMax(0.1 * size_);
  const Eigen::VectorXd by_swept = grown(reading);
  reading_size_ = fit::rms(by_swept);
  parts_.reading = of_rms_one(by_swept);
  if (!options_.outliers) return;
  // Deviations without the widening of an earlier round.
  const Eigen::VectorXd deviation =
      regression.residual.cwiseProduct(widening_).cwiseQuotient(regression.freedom.cwiseSqrt());
  std::vector<double> absolute(deviation.data(), deviation.data() + rows_);
  for (double& d : absolute) d = std::abs(d);
  const double robust = 1.4826 * record::median(absolute);
  const double limit = outlier_limit(noise_.degrees_of_freedom);
  noise_.outliers.clear();
  widening_.setOnes();
  for (Eigen::Index i = 0; i < rows_; ++i) {
    const double sigmas = std::abs(deviation[i]) / robust;
    if (!(sigmas > limit) || regression.freedom[i] < 0.1) continue;
    // What is far off says little: its pull falls as it moves further.
    widening_[i] = sigmas * sigmas / limit;
  }
  spare_levels();
  for (Eigen::Index i = 0; i < rows_; ++i)
    if (widening_[i] > 1.0) noise_.outliers.push_back(static_cast<std::size_t>(i));
}

}  // namespace raceway::fit
