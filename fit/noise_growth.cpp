#include <algorithm>
#include <array>
#include <cmath>

#include "fit/detail/noise_search.h"

namespace raceway::fit {

namespace {

constexpr double worth_growth = 6.63;     // of -2 ln L: 1 % level of one parameter
constexpr double worth_an_outlier = 6.0;  // the same: one row in twenty
constexpr double may_grow = 1.0;          // standard errors of a first regression
constexpr std::array growths{0.15, 0.3, 0.45, 0.6, 0.8, 1.0, 1.25, 1.6, 2.0};

}  // namespace

Eigen::VectorXd NoiseSearch::grown(const Eigen::VectorXd& reading) const {
  if (noise_.growth <= 0.0) return reading;
  return reading.array() * (readings_.swept.array() / noise_.largest_swept).pow(noise_.growth);
}

void NoiseSearch::find_growth() {
  if (!readings_.swept_by || !seems_to_grow()) return;
  const auto doubts = [this] {
    return worth_an_outlier * static_cast<double>((widening_.array() > 1.0).count());
  };
  const Shares shares = shares_;
  const Eigen::VectorXd widening = widening_;
  std::vector<Shares> few{{1.0, 0.0}, {0.97, 0.0}, {0.85, 0.0}, {0.5, 0.0}};
  if (parts_.slope.size() > 0) few.insert(few.end(), {{0.9, 0.1}, {0.7, 0.25}, {0.5, 0.45}});
  double best = find_shares() + doubts() - worth_growth, growth = 0.0;
  for (const double p : growths) {
    noise_.growth = p;
    parts_.reading = of_rms_one(grown(size_));
    widening_.setOnes();
    find_shares(few);
    if (options_.outliers) suspect_outliers();
    const double value = find_shares(few) + doubts();
    if (!(value < best)) continue;
    best = value;
    growth = p;
  }
  noise_.growth = growth;
  parts_.reading = of_rms_one(grown(size_));
  if (growth > 0.0) {
    widening_.setOnes();
    find_shares(few);
    if (options_.outliers) suspect_outliers();
    find_shares();
  } else {
    shares_ = shares;
    widening_ = widening;
  }
}

bool NoiseSearch::seems_to_grow() const {
  const Whitening independent(shape(shares_, parts_, by_record_), {}, 0.0, 0.0);
  const Regression r = regress(independent(columns_), independent(readings_.measured));
  const Eigen::ArrayXd x = readings_.swept.array().log();
  const Eigen::ArrayXd y = (r.residual.array().abs() / r.freedom.array().sqrt()).max(1e-12).log();
  const Eigen::ArrayXd w = r.freedom.array();
  const double mean_x = (w * x).sum() / w.sum(), mean_y = (w * y).sum() / w.sum();
  const double spread = (w * (x - mean_x).square()).sum();
  if (!(spread > 0.0)) return false;
  const double power = (w * (x - mean_x) * (y - mean_y)).sum() / spread;
  return power * std::sqrt(spread) > 1.11 * may_grow;
}

void NoiseSearch::allow_growths(double phi, double g, double best) {
  const double growth = noise_.growth;
  const Eigen::VectorXd reading = parts_.reading;
  const auto set = [&](double p) {
    parts_.reading = of_rms_one(Eigen::VectorXd(
        reading.array() * (readings_.swept.array() / noise_.largest_swept).pow(p - growth)));
  };
  double least = growth, most = growth;
  for (const double p : growths) {
    set(p);
    if (!(misfit(phi, g, shares_) < best + within_the_likely)) continue;
    least = std::min(least, p);
    most = std::max(most, p);
  }
  for (const double p : {least, most}) {
    if (p == growth) continue;
    set(p);
    double factor = 1.0;
    noise_.allowed.push_back(scaled(phi, g, shares_, factor));
  }
  parts_.reading = reading;
}

}  // namespace raceway::fit
