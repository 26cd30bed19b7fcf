#include "fit/least_squares.h"

#include <algorithm>
#include <cmath>

#include "algebra/detail/decompositions.h"

namespace raceway::fit {

LeastSquares::LeastSquares(const Eigen::MatrixXd& a, const Eigen::VectorXd& r) {
  const Eigen::Index count = a.cols();
  Eigen::MatrixXd joined(a.rows(), count + 1);
  joined << a, r;
  algebra::reduce_to_triangle(joined);
  const Eigen::Index rows = std::min(count, a.rows());
  a_ = joined.topLeftCorner(rows, count).triangularView<Eigen::Upper>();
  r_ = joined.col(count).head(rows);
}

double LeastSquares::fall(const Eigen::VectorXd& d) const {
  const Eigen::VectorXd image = a_ * d;
  return image.dot(2.0 * r_ - image);
}

bool LeastSquares::solve(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, double damping,
                         Eigen::VectorXd& d, std::vector<int>& side) const {
  const Eigen::Index count = a_.cols();
  Eigen::MatrixXd a = a_;
  Eigen::VectorXd r = r_;
  if (damping > 0.0) {
    a.conservativeResize(a_.rows() + count, Eigen::NoChange);
    a.bottomRows(count) = Eigen::MatrixXd((std::sqrt(damping) * a_.colwise().norm()).asDiagonal());
    r.conservativeResize(r_.size() + count);
    r.tail(count).setZero();
  }
  side.assign(static_cast<std::size_t>(count), 0);
  d = Eigen::VectorXd::Zero(count);
  const Eigen::MatrixXd gram = a.transpose() * a;
  const Eigen::VectorXd right = a.transpose() * r;
  for (int round = 0; round < 50; ++round) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index k = 0; k < count; ++k) {
      const int s = side[static_cast<std::size_t>(k)];
      if (s == 0)
        free.push_back(k);
      else
        d[k] = s < 0 ? lower[k] : upper[k];
    }
    if (!free.empty()) {
      Eigen::MatrixXd columns(a.rows(), static_cast<Eigen::Index>(free.size()));
      Eigen::VectorXd rest = r;
      for (Eigen::Index k = 0; k < count; ++k)
        if (side[static_cast<std::size_t>(k)] != 0) rest -= a.col(k) * d[k];
      for (std::size_t j = 0; j < free.size(); ++j)
        columns.col(static_cast<Eigen::Index>(j)) = a.col(free[j]);
      const Eigen::VectorXd solution = algebra::least_squares(columns, rest);
      if (!solution.allFinite()) return false;
      for (std::size_t j = 0; j < free.size(); ++j)
        d[free[j]] = solution[static_cast<Eigen::Index>(j)];
    }
    // The worst violation first: beyond a bound, then a held one that wants back inside.
    Eigen::Index worst = -1;
    double most = 0.0;
    int worst_side = 0;
    for (const Eigen::Index k : free) {
      const double below = lower[k] - d[k], above = d[k] - upper[k];
      if (std::max(below, above) > most) {
        most = std::max(below, above);
        worst = k;
        worst_side = below > above ? -1 : 1;
      }
    }
    if (worst >= 0) {
      side[static_cast<std::size_t>(worst)] = worst_side;
      continue;
    }
    const Eigen::VectorXd downhill = right - gram * d;
    for (Eigen::Index k = 0; k < count; ++k) {
      const int s = side[static_cast<std::size_t>(k)];
      const double inward = s < 0 ? downhill[k] : s > 0 ? -downhill[k] : 0.0;
      if (inward > most + 1e-9 * std::sqrt(gram(k, k)) * r.norm()) {
        most = inward;
        worst = k;
      }
    }
    if (worst < 0) return true;
    side[static_cast<std::size_t>(worst)] = 0;
  }
  return false;
}

}  // namespace raceway::fit
