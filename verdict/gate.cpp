#include "verdict/gate.h"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <type_traits>

#include "algebra/detail/decompositions.h"
#include "fit/distributions.h"
#include "fit/subspace.h"

namespace raceway::verdict {

namespace {

constexpr double tail_resolved = 20.0;  // draws beyond the observed score
constexpr float single_error = 1e-3F;   // of a score in single precision, with a wide margin
constexpr Eigen::Index together = 500;  // draws whose scores stay in the cache

}  // namespace

struct NullDraws::Normals {
  Eigen::MatrixXd scores;  // draws x scores
  Eigen::MatrixXf single;  // the same
  Eigen::ArrayXd scale;    // one more for each draw

  Normals(Eigen::Index count, int draws) : scores(draws, count), scale(draws) {
    boost::random::mt19937 engine(20210305);
    boost::random::normal_distribution<double> normal;
    boost::random::uniform_01<double> uniform;
    for (Eigen::Index k = 0; k < count; ++k)
      for (Eigen::Index d = 0; d < draws; ++d) scores(d, k) = normal(engine);
    for (Eigen::Index d = 0; d < draws; ++d) scale[d] = fit::normal_quantile(uniform(engine));
    single = scores.cast<float>();
  }
};

/// The last set is kept for the next diagnosis.
std::shared_ptr<const NullDraws::Normals> NullDraws::draw(Eigen::Index scores, int draws) {
  static std::mutex mutex;
  static std::shared_ptr<const Normals> last;
  const std::scoped_lock lock(mutex);
  if (!last || last->scores.cols() != scores || last->scores.rows() != draws)
    last = std::make_shared<const Normals>(scores, draws);
  return last;
}

double NullDraws::p_value(const Eigen::MatrixXd& correlation, const std::vector<bool>& one_sided,
                          double degrees_of_freedom, double observed) const {
  const Eigen::Index count = correlation.cols();
  if (count == 0 || !(observed > 0.0)) return 1.0;
  const double tail = fit::t_above(degrees_of_freedom, observed);
  double bonferroni = 0.0;
  for (Eigen::Index k = 0; k < count; ++k)
    bonferroni += one_sided[static_cast<std::size_t>(k)] ? tail : 2.0 * tail;
  const auto draws = static_cast<double>(draws_);
  // Too rare to be counted, or too common to matter: the bounds say enough.
  if (bonferroni * draws < tail_resolved) return std::min(1.0, bonferroni);
  if (tail > 0.2) return tail;

  const algebra::SymmetricEigen eigen = algebra::symmetric_eigen(correlation);
  const Eigen::MatrixXd root = eigen.vectors * eigen.values.cwiseMax(0.0).cwiseSqrt().asDiagonal() *
                               eigen.vectors.transpose();
  if (!normals_) normals_ = draw(scores_, draws_);
  // Wilson and Hilferty: χ² quantiles to three digits, where the exact ones cost ten thousand
  // inversions.
  const double c = 2.0 / (9.0 * degrees_of_freedom);
  const Eigen::ArrayXd limit =
      observed *
      (1.0 - c + normals_->scale * std::sqrt(c)).cwiseMax(0.0).cube().sqrt().cwiseMax(0.5);
  const auto largest = [&](const auto& scores) {
    using Scores = std::decay_t<decltype(scores)>;
    using Scalar = typename Scores::Scalar;
    Eigen::Array<Scalar, Eigen::Dynamic, 1> most =
        Eigen::Array<Scalar, Eigen::Dynamic, 1>::Zero(scores.rows());
    for (Eigen::Index k = 0; k < count; ++k)
      if (one_sided[static_cast<std::size_t>(k)])
        most = most.max(scores.col(k).array());
      else
        most = most.max(scores.col(k).array().abs());
    return most;
  };
  // Single precision decides but for the few draws too near to their limit.
  const Eigen::MatrixXf single_root = root.cast<float>();
  int beyond = 0;
  Eigen::MatrixXf scores;
  for (Eigen::Index first = 0; first < draws_; first += together) {
    const Eigen::Index rows = std::min<Eigen::Index>(together, draws_ - first);
    scores.noalias() = normals_->single.block(first, 0, rows, count) * single_root;
    const Eigen::ArrayXf most = largest(scores);
    for (Eigen::Index d = 0; d < rows; ++d) {
      const double above = most[d] - limit[first + d];
      if (std::abs(above) > single_error)
        beyond += above > 0.0 ? 1 : 0;
      else if (largest((normals_->scores.row(first + d).head(count) * root).eval())[0] >=
               limit[first + d])
        ++beyond;
    }
  }
  return (1.0 + beyond) / (1.0 + draws);
}

double Gate::p_value() const {
  return std::max(allowed_p_value, std::min(1.0, 2.0 * std::min(surface_p_value, score_p_value)));
}

Gate open_gate(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& residual,
               const Eigen::MatrixXd& surface, const Eigen::MatrixXd& scores,
               const std::vector<bool>& one_sided, double degrees_of_freedom,
               const NullDraws& draws) {
  Gate gate;
  const Eigen::VectorXd rest = fit::project_off(tangent, residual);
  const Eigen::MatrixXd smooth =
      fit::independent_columns({fit::orthonormal(tangent), surface}, {0.5, 1e-4},
                               std::max<Eigen::Index>(tangent.cols() + 1, residual.size() / 3))
          .eval();
  const Eigen::MatrixXd own = smooth.rightCols(
      smooth.cols() - std::min<Eigen::Index>(smooth.cols(), fit::orthonormal(tangent).cols()));
  gate.surface_terms = static_cast<int>(own.cols());
  if (gate.surface_terms > 0) {
    gate.surface_statistic = (own.transpose() * rest).squaredNorm() / gate.surface_terms;
    gate.surface_p_value =
        fit::f_above(gate.surface_terms, degrees_of_freedom, gate.surface_statistic);
  }
  gate.projected = fit::project_off(tangent, scores);
  gate.visibility = Eigen::VectorXd::Zero(scores.cols());
  gate.scores = Eigen::VectorXd::Zero(scores.cols());
  std::vector<Eigen::Index> visible;
  for (Eigen::Index k = 0; k < scores.cols(); ++k) {
    const double full = scores.col(k).norm(), left = gate.projected.col(k).norm();
    gate.visibility[k] = full > 0.0 ? left / full : 0.0;
    if (gate.visibility[k] < invisible) continue;
    visible.push_back(k);
    gate.scores[k] = gate.projected.col(k).dot(rest) / left;
  }
  if (visible.empty()) return gate;
  Eigen::MatrixXd unit = gate.projected(Eigen::all, visible);
  std::vector<bool> sided;
  gate.largest_score = -std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < visible.size(); ++j) {
    unit.col(static_cast<Eigen::Index>(j)).normalize();
    const bool positive = one_sided[static_cast<std::size_t>(visible[j])];
    sided.push_back(positive);
    const double score = positive ? gate.scores[visible[j]] : std::abs(gate.scores[visible[j]]);
    if (score > gate.largest_score) {
      gate.largest_score = score;
      gate.largest = static_cast<int>(visible[j]);
    }
  }
  gate.score_p_value =
      draws.p_value(unit.transpose() * unit, sided, degrees_of_freedom, gate.largest_score);
  return gate;
}

}  // namespace raceway::verdict
