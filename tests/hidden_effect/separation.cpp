#include "tests/hidden_effect/separation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hidden_effect {
namespace {

/// Scaled residuals of the torque without noise against the law with one candidate.
class Misfit {
 public:
  Misfit(const Rig& rig, const Effect* candidate) : rig_(rig), candidate_(candidate) {
    for (const Reading& r : rig.train)
      sigma_.push_back(rig.setup.noise == Noise::independent
                           ? rig.setup.detail.level * std::abs(r.torque)
                           : r.sigma);
  }

  /// x = ln f0, ln z, size, ln shape.
  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& x) const {
    BaseLaw law;  // the believed law: only its factors are free
    law.f0 = std::exp(x[0]);
    law.z = std::exp(x[1]);
    std::vector<Hidden> hidden;
    if (candidate_ != nullptr)
      hidden.push_back({candidate_, {x[2], x.size() > 3 ? std::exp(x[3]) : candidate_->shape}});
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
  const Eigen::Index count = candidate == nullptr ? 2 : shaped ? 4 : 3;
  Eigen::VectorXd start(count), step(count), lower(count), upper(count);
  start.head(2) << std::log(1.5), std::log(1e-3);
  step.head(2).setConstant(1e-6);
  lower.head(2) << std::log(0.01), std::log(1e-6);
  upper.head(2) << std::log(30.0), std::log(0.02);
  if (candidate == nullptr) return least(misfit, start, step, lower, upper);
  if (shaped) {
    start[3] = std::log(std::max(candidate->shape, 1e-4));
    lower[3] = std::log(std::max(candidate->shape_lower, 1e-5));
    upper[3] = std::log(candidate->shape_upper);
    step[3] = 1e-5;
  }
  // A size that changes the torque by about 5 % sets the scale.
  double scale = candidate->largest;
  Eigen::VectorXd x = start;
  for (; scale > 1e-12 * candidate->largest; scale *= 0.25) {
    x[2] = scale;
    if ((misfit(x) - Misfit(rig, nullptr)(start.head(2))).norm() <
        0.05 / rig.setup.detail.level * std::sqrt(static_cast<double>(rig.train.size())))
      break;
  }
  step[2] = 1e-5 * scale;
  lower[2] = candidate->negative ? -candidate->largest : 0.0;
  upper[2] = candidate->largest;
  double best = std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0.0 && !candidate->negative) continue;
    start[2] = sign * scale;
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
