#include "tests/hidden_effect/likelihood.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hidden_effect {
namespace {

constexpr double right_at = 24.0;  // [C]; a sensor with a wrong gain is right there

const std::array<Datum, 4> files{{
    {"torque-creep", 1e5, [](double size, Point& p) { return size * share_of_day(p.time); }},
    {"load-cell-drift", 0.02,
     [](double size, Point& p) {
       p.load *= 1.0 + size * (p.temperature - 22.0);
       return 0.0;
     }},
    {"temperature-offset", 30.0,
     [](double size, Point& p) {
       p.temperature -= size;
       return 0.0;
     }},
    {"temperature-gain", 0.6,
     [](double size, Point& p) {
       p.temperature = right_at + (p.temperature - right_at) / (1.0 + size);
       return 0.0;
     }},
}};

/// The free numbers of the base law: logarithms of its factors. An unknown law has free exponents
/// as well.
class Factors {
 public:
  explicit Factors(const BaseLaw& truth) : truth_(truth) {}
  [[nodiscard]] Eigen::Index count() const {
    return truth_.contacts ? 1 : truth_.formula == Formula::houpert ? 5 : 2;
  }
  [[nodiscard]] BaseLaw law(const Eigen::VectorXd& x, Eigen::Index at) const {
    BaseLaw believed = truth_;
    if (truth_.contacts) {
      believed.rolling_factor = std::exp(x[at]);
    } else if (truth_.formula == Formula::palmgren) {
      believed.f0 = std::exp(x[at]);
      believed.z = std::exp(x[at + 1]);
    } else {
      believed.rolling_factor = std::exp(x[at]);
      believed.sliding_factor = std::exp(x[at + 1]);
      if (truth_.formula == Formula::houpert)
        believed.powers = {std::exp(x[at + 2]), std::exp(x[at + 3]), std::exp(x[at + 4])};
    }
    return believed;
  }
  void set(Eigen::Index at, Eigen::VectorXd& start, Eigen::VectorXd& lower,
           Eigen::VectorXd& upper) const {
    const auto put = [&](double value, double least, double most) {
      start[at] = std::log(value);
      lower[at] = std::log(least);
      upper[at++] = std::log(most);
    };
    if (truth_.contacts) return put(1.0, 0.01, 5.0);
    if (truth_.formula == Formula::palmgren) {
      put(1.5, 0.01, 30.0);
      return put(1e-3, 1e-6, 0.02);
    }
    put(1.0, 1e-3, 100.0);
    put(1.0, 1e-3, 100.0);
    if (truth_.formula == Formula::houpert)
      for (const double power : truth_.powers) put(power, 0.2 * power, 3.0 * power);
  }

 private:
  const BaseLaw& truth_;
};

bool has_shape(const Effect& e) { return e.shape_lower < e.shape_upper; }

}  // namespace

std::span<const Datum> data_of_the_files() { return files; }

int Hypothesis::numbers() const {
  int count = datum == nullptr ? 0 : 1;
  for (const Effect* e : effects) count += has_shape(*e) ? 2 : 1;
  return count;
}

Eigen::MatrixXd covariance_of_noise(const Rig& rig, std::span<const Reading> rows) {
  const Setup& s = rig.setup;
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(n, n);
  // The zeros of the runs are in proportion to the rms torque, as in misread_torques().
  const double zero = s.mistake.reset * rms_torque(rows);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      const Reading &a = rows[static_cast<std::size_t>(i)], &b = rows[static_cast<std::size_t>(k)];
      if (i == k) C(i, k) += a.sigma * a.sigma;
      if (i != k && s.noise == Noise::autoregressive)
        C(i, k) += a.sigma * b.sigma * std::pow(s.detail.correlation, std::abs(i - k));
      if (a.run != b.run) continue;
      if (s.noise == Noise::run_offsets)
        C(i, k) += s.detail.offset * s.detail.offset * std::abs(a.torque * b.torque);
      C(i, k) += zero * zero;
    }
  if (s.noise == Noise::outliers)
    for (Eigen::Index i = 0; i < n; ++i) {
      const Reading& r = rows[static_cast<std::size_t>(i)];
      // The generator moves an outlier by at least 6.
      if (std::abs(r.measured - r.torque) > 5.5 * r.sigma) C(i, i) *= 1e6;
    }
  return C;
}

Likelihood::Likelihood(const Rig& rig, std::span<const Reading> rows, Eigen::VectorXd torques,
                       const Eigen::MatrixXd& covariance)
    : rig_(rig),
      rows_(rows),
      torques_(std::move(torques)),
      lower_(covariance.llt().matrixL()),
      independent_(covariance.isDiagonal(0.0)),
      bearings_{rig.bearing} {
  if (rig.second_record > 0) bearings_.push_back(bearing_of_second_record(rig.setup));
}

Eigen::Index Likelihood::base_numbers() const {
  return Factors(rig_.setup.law).count() * static_cast<Eigen::Index>(bearings_.size());
}

double Likelihood::log_determinant() const { return 2.0 * lower_.diagonal().array().log().sum(); }

/// x = numbers of the base law of each record; for each effect size and ln shape; the datum's size.
Eigen::VectorXd Likelihood::residuals(const Hypothesis& hypothesis,
                                      const Eigen::VectorXd& x) const {
  const Factors factors(rig_.setup.law);
  std::vector<BaseLaw> laws;
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < bearings_.size(); ++k, at += factors.count())
    laws.push_back(factors.law(x, at));
  std::vector<Hidden> hidden;
  for (const Effect* e : hypothesis.effects) {
    hidden.push_back({e, {x[at], has_shape(*e) ? std::exp(x[at + 1]) : e->shape}});
    at += has_shape(*e) ? 2 : 1;
  }
  Eigen::VectorXd r(torques_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::size_t record = bearings_.size() > 1 && i >= rig_.second_record ? 1 : 0;
    Point point = rows_[i].point;
    const double added =
        hypothesis.datum == nullptr ? 0.0 : hypothesis.datum->correct(x[at], point);
    const auto row = static_cast<Eigen::Index>(i);
    r[row] = added + torque(bearings_[record], laws[record], point, hidden) - torques_[row];
  }
  if (independent_)
    r.array() /= lower_.diagonal().array();
  else
    lower_.triangularView<Eigen::Lower>().solveInPlace(r);
  return r;
}

double Likelihood::least_from(const Hypothesis& hypothesis, Eigen::VectorXd x,
                              const Eigen::VectorXd& step, const Eigen::VectorXd& lower,
                              const Eigen::VectorXd& upper) const {
  Eigen::VectorXd r = residuals(hypothesis, x);
  double cost = r.squaredNorm(), damping = 1e-3;
  for (int iteration = 0; iteration < 60; ++iteration) {
    Eigen::MatrixXd J(r.size(), x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      Eigen::VectorXd moved = x;
      moved[k] += moved[k] + step[k] <= upper[k] ? step[k] : -step[k];
      J.col(k) = (residuals(hypothesis, moved) - r) / (moved[k] - x[k]);
    }
    const Eigen::MatrixXd H = J.transpose() * J;
    const Eigen::VectorXd g = J.transpose() * r;
    bool better = false;
    for (; damping < 1e10; damping *= 5.0) {
      Eigen::MatrixXd damped = H;
      damped.diagonal() += damping * H.diagonal() + Eigen::VectorXd::Constant(x.size(), 1e-30);
      const Eigen::VectorXd next = (x - damped.ldlt().solve(g)).cwiseMax(lower).cwiseMin(upper);
      const Eigen::VectorXd trial = residuals(hypothesis, next);
      const double trial_cost = trial.squaredNorm();
      if (!(trial_cost < cost)) continue;
      better = cost - trial_cost > 1e-6 * cost + 1e-9;
      x = next;
      r = trial;
      cost = trial_cost;
      damping = std::max(0.1 * damping, 1e-9);
      break;
    }
    if (!better) break;
  }
  return cost;
}

double Likelihood::scale_of(const Hypothesis& one, double largest,
                            const Eigen::VectorXd& start) const {
  const std::string_view id = one.datum != nullptr ? one.datum->id : one.effects.front()->id;
  if (const auto known = scales_.find(id); known != scales_.end()) return known->second;
  Eigen::VectorXd x(start.size() + one.numbers());
  x.head(start.size()) = start;
  if (one.numbers() > 1) x[start.size() + 1] = std::log(std::max(one.effects.front()->shape, 1e-4));
  const Eigen::VectorXd without = residuals({}, start);
  double scale = largest;
  for (; scale > 1e-12 * largest; scale *= 0.25) {
    x[start.size()] = scale;
    if ((residuals(one, x) - without).norm() <
        0.05 / rig_.setup.detail.level * std::sqrt(static_cast<double>(rows_.size())))
      break;
  }
  return scales_[id] = scale;
}

double Likelihood::least(const Hypothesis& hypothesis) const {
  const Factors factors(rig_.setup.law);
  const Eigen::Index base = base_numbers();
  const Eigen::Index count = base + hypothesis.numbers();
  Eigen::VectorXd start(count), step = Eigen::VectorXd::Constant(count, 1e-6), lower(count),
                                upper(count);
  for (Eigen::Index at = 0; at < base; at += factors.count()) factors.set(at, start, lower, upper);
  const Eigen::VectorXd plain = start.head(base);
  std::vector<Eigen::Index> two_sided;
  Eigen::Index at = base;
  const auto put = [&](const Hypothesis& one, double largest, bool negative) {
    start[at] = scale_of(one, largest, plain);
    step[at] = 1e-5 * start[at];
    lower[at] = negative ? -largest : 0.0;
    upper[at] = largest;
    if (negative) two_sided.push_back(at);
    ++at;
  };
  for (const Effect* e : hypothesis.effects) {
    put({.effects = {e}}, e->largest, e->negative);
    if (!has_shape(*e)) continue;
    start[at] = std::log(std::max(e->shape, 1e-4));
    lower[at] = std::log(std::max(e->shape_lower, 1e-5));
    upper[at] = std::log(e->shape_upper);
    step[at++] = 1e-5;
  }
  if (hypothesis.datum != nullptr)
    put({.datum = hypothesis.datum}, hypothesis.datum->largest, true);
  // Each choice of signs is a start of its own.
  double best = std::numeric_limits<double>::infinity();
  for (unsigned signs = 0; signs < 1U << two_sided.size(); ++signs) {
    Eigen::VectorXd x = start;
    for (std::size_t k = 0; k < two_sided.size(); ++k)
      if ((signs >> k & 1U) != 0) x[two_sided[k]] *= -1.0;
    best = std::min(best, least_from(hypothesis, x, step, lower, upper));
  }
  return best;
}

}  // namespace hidden_effect
