#include "tests/hidden_effect/separation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hidden_effect {
namespace {

/// The factors of the believed law, of which the user frees the logarithms.
class Factors {
 public:
  explicit Factors(const BaseLaw& truth) : contacts_(truth.contacts) {}
  [[nodiscard]] Eigen::Index count() const { return contacts_ ? 1 : 2; }
  [[nodiscard]] BaseLaw law(const Eigen::VectorXd& x) const {
    BaseLaw believed;
    believed.contacts = contacts_;
    if (contacts_) {
      believed.rolling_factor = std::exp(x[0]);
    } else {
      believed.f0 = std::exp(x[0]);
      believed.z = std::exp(x[1]);
    }
    return believed;
  }
  void set(Eigen::VectorXd& start, Eigen::VectorXd& lower, Eigen::VectorXd& upper) const {
    if (contacts_) {
      start[0] = 0.0;
      lower[0] = std::log(0.01);
      upper[0] = std::log(5.0);
      return;
    }
    start.head(2) << std::log(1.5), std::log(1e-3);
    lower.head(2) << std::log(0.01), std::log(1e-6);
    upper.head(2) << std::log(30.0), std::log(0.02);
  }

 private:
  bool contacts_;
};

/// Scaled residuals of the torque without noise against the law with one candidate.
class Misfit {
 public:
  Misfit(const Rig& rig, const Effect* candidate) : rig_(rig), candidate_(candidate) {
    for (const Reading& r : rig.train)
      sigma_.push_back(rig.setup.noise == Noise::independent
                           ? rig.setup.detail.level * std::abs(r.torque)
                           : r.sigma);
  }

  /// x = logarithms of the law's own factors, size, ln shape.
  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& x) const {
    const Factors factors(rig_.setup.law);
    const BaseLaw law = factors.law(x);
    std::vector<Hidden> hidden;
    const Eigen::Index at = factors.count();
    if (candidate_ != nullptr)
      hidden.push_back(
          {candidate_, {x[at], x.size() > at + 1 ? std::exp(x[at + 1]) : candidate_->shape}});
    Eigen::VectorXd r(static_cast<Eigen::Index>(rig_.train.size()));
    for (std::size_t i = 0; i < rig_.train.size(); ++i)
      r[static_cast<Eigen::Index>(i)] =
          (torque(rig_.bearing, law, rig_.train[i].point, hidden) - rig_.train[i].torque) /
          sigma_[i];
    return r;
  }

 private:
  const Rig& rig_;
  const Effect* candidate_;
  std::vector<double> sigma_;
};

/// Least misfit from a start, within bounds.
double least(const Misfit& misfit, Eigen::VectorXd x, const Eigen::VectorXd& step,
             const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  Eigen::VectorXd r = misfit(x);
  double cost = r.squaredNorm(), damping = 1e-3;
  for (int iteration = 0; iteration < 60; ++iteration) {
    Eigen::MatrixXd J(r.size(), x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      Eigen::VectorXd moved = x;
      moved[k] += moved[k] + step[k] <= upper[k] ? step[k] : -step[k];
      J.col(k) = (misfit(moved) - r) / (moved[k] - x[k]);
    }
    const Eigen::MatrixXd H = J.transpose() * J;
    const Eigen::VectorXd g = J.transpose() * r;
    bool better = false;
    for (; damping < 1e10; damping *= 5.0) {
      Eigen::MatrixXd damped = H;
      damped.diagonal() += damping * H.diagonal() + Eigen::VectorXd::Constant(x.size(), 1e-30);
      const Eigen::VectorXd next = (x - damped.ldlt().solve(g)).cwiseMax(lower).cwiseMin(upper);
      const Eigen::VectorXd trial = misfit(next);
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

double least_with(const Rig& rig, const Effect* candidate) {
  const Misfit misfit(rig, candidate);
  const bool shaped = candidate != nullptr && candidate->shape_lower < candidate->shape_upper;
  const Factors factors(rig.setup.law);
  const Eigen::Index size = factors.count();  // place of the candidate's
  const Eigen::Index count = size + (candidate == nullptr ? 0 : shaped ? 2 : 1);
  Eigen::VectorXd start(count), step(count), lower(count), upper(count);
  factors.set(start, lower, upper);
  step.head(size).setConstant(1e-6);
  if (candidate == nullptr) return least(misfit, start, step, lower, upper);
  if (shaped) {
    start[size + 1] = std::log(std::max(candidate->shape, 1e-4));
    lower[size + 1] = std::log(std::max(candidate->shape_lower, 1e-5));
    upper[size + 1] = std::log(candidate->shape_upper);
    step[size + 1] = 1e-5;
  }
  // A size that changes the torque by about 5 % sets the scale.
  double scale = candidate->largest;
  Eigen::VectorXd x = start;
  for (; scale > 1e-12 * candidate->largest; scale *= 0.25) {
    x[size] = scale;
    if ((misfit(x) - Misfit(rig, nullptr)(start.head(size))).norm() <
        0.05 / rig.setup.detail.level * std::sqrt(static_cast<double>(rig.train.size())))
      break;
  }
  step[size] = 1e-5 * scale;
  lower[size] = candidate->negative ? -candidate->largest : 0.0;
  upper[size] = candidate->largest;
  double best = std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0.0 && !candidate->negative) continue;
    start[size] = sign * scale;
    best = std::min(best, least(misfit, start, step, lower, upper));
  }
  return best;
}

}  // namespace

Visibility visibility(const Rig& rig) {
  const std::vector<std::string_view> right = rig.accepted();
  Visibility v;
  v.detection = v.separation = least_with(rig, nullptr);
  double odds_against = 0.0;
  for (const Effect& candidate : catalogue_effects()) {
    if (std::find(right.begin(), right.end(), candidate.id) != right.end()) continue;
    if (rig.setup.law.contacts && within_contacts(candidate.id)) continue;
    const double left = least_with(rig, &candidate);
    const double wins = 0.5 * std::erfc(-std::sqrt(std::max(left, 0.0) / 8.0));
    odds_against += (1.0 - wins) / wins;
    if (left >= v.separation) continue;
    v.separation = left;
    v.nearest = candidate.id;
  }
  v.right_first = 1.0 / (1.0 + odds_against);
  return v;
}

}  // namespace hidden_effect
