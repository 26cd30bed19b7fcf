#include "correction/gauss_markov.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raceway::correction {
namespace {

/// What a time dt adds to the variance.
double fresh_variance(const Unknown& u, double decay, double dt) {
  return u.std * u.std * (1.0 - decay * decay) + u.walk * u.walk * dt;
}

/// What a rate has moved in a time dt, and what that adds to the variances.
///
///   moved = T (1 - a),   variance = s² T² (2 dt/T - 3 + 4 a - a²),   with the rate: s² T (1 - a)²
///
/// Source: the integral of the process, by hand.
struct Moved {
  double by, variance, with_rate;
};

Moved moved(const Unknown& rate, double dt) {
  const double x = dt / rate.memory, rise = -std::expm1(-x), s2 = rate.std * rate.std;
  // 2 x - 3 + 4 a - a² loses its digits where x is small.
  const double area = x < 1e-2 ? x * x * x * (2.0 / 3 - x * (1.0 / 2 - x * 7.0 / 30))
                               : 2.0 * (x - rise) - rise * rise;
  return {rate.memory * rise, s2 * rate.memory * rate.memory * area,
          s2 * rate.memory * rise * rise};
}

/// Rounding may leave a variance that is.
double not_negative(double variance) { return std::max(variance, 0.0); }

Eigen::Index index(std::size_t k) { return static_cast<Eigen::Index>(k); }

Eigen::VectorXd decays(const std::vector<Unknown>& unknowns, double dt) {
  Eigen::VectorXd a(index(unknowns.size()));
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    a[index(k)] = std::exp(-dt / unknowns[k].memory);
  return a;
}

Eigen::Map<const Eigen::VectorXd> as_vector(std::span<const double> values) {
  return {values.data(), index(values.size())};
}

}  // namespace

UnknownsFilter::UnknownsFilter(std::vector<Unknown> unknowns)
    : unknowns_(std::move(unknowns)),
      x_(Eigen::VectorXd::Zero(index(unknowns_.size()))),
      p_(Eigen::MatrixXd::Zero(index(unknowns_.size()), index(unknowns_.size()))) {
  for (std::size_t k = 0; k < unknowns_.size(); ++k) {
    if (!(unknowns_[k].std > 0.0) || !(unknowns_[k].memory > 0.0))
      throw std::invalid_argument(
          unknowns_[k].name + ": standard deviation and correlation time (memory) must be above 0");
    reset(k);
  }
}

UnknownsFilter::Expected UnknownsFilter::expected(std::span<const double> weights,
                                                  double dt) const {
  const Eigen::VectorXd a = decays(unknowns_, dt);
  Eigen::VectorXd h = as_vector(weights).cwiseProduct(a);
  double fresh = 0.0;  // from what came since
  for (std::size_t k = 0; k < unknowns_.size(); ++k) {
    const Unknown& u = unknowns_[k];
    fresh += weights[k] * weights[k] * fresh_variance(u, a[index(k)], dt);
    if (u.rate_of < 0) continue;
    const Moved m = moved(u, dt);
    const double weight = weights[static_cast<std::size_t>(u.rate_of)];
    h[index(k)] += weight * m.by;
    fresh += weight * weight * m.variance + 2.0 * weight * weights[k] * m.with_rate;
  }
  return {.mean = h.dot(x_), .variance = not_negative(h.dot(p_ * h)) + fresh};
}

void UnknownsFilter::advance(double dt) {
  const Eigen::VectorXd a = decays(unknowns_, dt);
  Eigen::MatrixXd step = a.asDiagonal();
  Eigen::MatrixXd fresh = Eigen::MatrixXd::Zero(p_.rows(), p_.cols());
  for (std::size_t k = 0; k < unknowns_.size(); ++k) {
    const Unknown& u = unknowns_[k];
    fresh(index(k), index(k)) += fresh_variance(u, a[index(k)], dt);
    if (u.rate_of < 0) continue;
    const Moved m = moved(u, dt);
    step(u.rate_of, index(k)) += m.by;
    fresh(u.rate_of, u.rate_of) += m.variance;
    fresh(u.rate_of, index(k)) += m.with_rate;
    fresh(index(k), u.rate_of) += m.with_rate;
  }
  x_ = step * x_;
  p_ = step * p_ * step.transpose() + fresh;
}

void UnknownsFilter::learn(std::span<const double> weights, double reading, double reading_std) {
  const auto h = as_vector(weights);
  const double noise = reading_std * reading_std;
  const Eigen::VectorXd ph = p_ * h;
  const double variance = not_negative(h.dot(ph)) + noise;
  const double innovation = reading - h.dot(x_);
  const Eigen::VectorXd gain = ph / variance;
  x_ += gain * innovation;
  // (1 - g h') P (1 - g h')' + r² g g', one factor after the other.
  p_ -= gain * ph.transpose();
  const Eigen::VectorXd rest = p_ * h;
  p_ += (noise * gain - rest) * gain.transpose();
  p_ = 0.5 * (p_ + p_.transpose()).eval();
  keep_bounds();
}

void UnknownsFilter::keep_bounds() {
  for (std::size_t k = 0; k < unknowns_.size(); ++k) {
    const double beyond = std::abs(x_[index(k)]) - unknowns_[k].bound;
    if (!(beyond > 0.0) || !(p_(index(k), index(k)) > 0.0)) continue;
    x_ -= p_.col(index(k)) / p_(index(k), index(k)) * std::copysign(beyond, x_[index(k)]);
    x_[index(k)] = std::copysign(unknowns_[k].bound, x_[index(k)]);
  }
  // Moving along one may have carried another beyond.
  for (std::size_t k = 0; k < unknowns_.size(); ++k)
    x_[index(k)] = std::clamp(x_[index(k)], -unknowns_[k].bound, unknowns_[k].bound);
}

void UnknownsFilter::reset(std::size_t unknown) {
  const Unknown& u = unknowns_[unknown];
  const double first = std::isnan(u.first_std) ? u.std : u.first_std;
  const Eigen::Index k = index(unknown);
  x_[k] = 0.0;
  p_.row(k).setZero();
  p_.col(k).setZero();
  p_(k, k) = first * first;
}

double UnknownsFilter::value(std::size_t unknown) const { return x_[index(unknown)]; }

double UnknownsFilter::std(std::size_t unknown) const {
  return std::sqrt(not_negative(p_(index(unknown), index(unknown))));
}

bool UnknownsFilter::at_bound(std::size_t unknown) const {
  return std::abs(x_[index(unknown)]) >= unknowns_[unknown].bound;
}

}  // namespace raceway::correction
