#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "algebra/detail/decompositions.h"
#include "tolerance/approximation.h"

namespace raceway::tolerance {
namespace {

/// Twice the sum over the correlation of what is left with itself until that is lost, and 1: each
/// channel beside itself alone.
double memory_of(const fit::Means& means, const Eigen::VectorXd& left) {
  constexpr double lost = 0.05;
  std::vector<Eigen::Index> first{0};
  const auto channel = [&](Eigen::Index i) {
    return means.list[static_cast<std::size_t>(i)].channel;
  };
  for (Eigen::Index i = 1; i < left.size(); ++i)
    if (channel(i) != channel(i - 1)) first.push_back(i);
  first.push_back(left.size());
  Eigen::Index longest = 0;
  for (std::size_t c = 0; c + 1 < first.size(); ++c)
    longest = std::max(longest, first[c + 1] - first[c]);
  // In the weight of the first, so that one channel counts as it is.
  Eigen::VectorXd r = left;
  for (Eigen::Index i = 0; i < r.size(); ++i)
    r[i] *= means.list[static_cast<std::size_t>(i)].weight / means.list.front().weight;
  const double square = r.squaredNorm();
  double sum = 1.0;
  for (Eigen::Index lag = 1; lag < longest / 2 && square > 0.0; ++lag) {
    double product = 0.0;
    for (std::size_t c = 0; c + 1 < first.size(); ++c)
      if (const Eigen::Index count = first[c + 1] - first[c] - lag; count > 0)
        product += r.segment(first[c], count).dot(r.segment(first[c] + lag, count));
    const double rho = product / square;
    if (rho < lost) break;
    sum += 2.0 * rho;
  }
  return sum;
}

/// Mean time between neighbouring means of the first channel [s].
double spacing_of(const fit::Means& means) {
  const auto end = std::find_if(
      means.list.begin(), means.list.end(),
      [&](const fit::Means::Mean& m) { return m.channel != means.list.front().channel; });
  const auto count = end - means.list.begin();
  return count > 1 ? ((end - 1)->time - means.list.front().time) / static_cast<double>(count - 1)
                   : unset;
}

/// What a model's own coarseness may add along each of these directions of weighed errors: as much
/// as an error of the declared size does that follows them throughout a channel; errors of
/// different channels taken as independent. More readings do not make it smaller.
Eigen::VectorXd coarseness(const fit::Subject& subject, const fit::Means& means,
                           const Eigen::MatrixXd& directions) {
  const std::vector<fit::Measured> measured = subject.measured();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(directions.cols());
  for (std::size_t c = 0; c < measured.size(); ++c) {
    if (!(measured[c].model_error > 0.0)) continue;
    double weight = 0.0;
    Eigen::VectorXd share = Eigen::VectorXd::Zero(directions.cols());
    for (Eigen::Index i = 0; i < means.size(); ++i) {
      const fit::Means::Mean& mean = means.list[static_cast<std::size_t>(i)];
      if (mean.channel != c) continue;
      weight += mean.weight * mean.weight;
      share += directions.row(i).transpose().cwiseAbs2();
    }
    sum += measured[c].model_error * measured[c].model_error * weight * share;
  }
  return sum;
}

/// Slopes of the weighted means by the parameters that move, and below them of their priors.
Eigen::MatrixXd with_priors(const Approximation& a, const std::vector<Eigen::Index>& moving,
                            double variance, const Eigen::MatrixXd& slopes) {
  if (!(a.prior_weight > 0.0)) return slopes;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(slopes.rows() + slopes.cols(), slopes.cols());
  all.topRows(slopes.rows()) = slopes;
  for (Eigen::Index j = 0; j < slopes.cols(); ++j)
    if (const record::Prior& prior =
            a.parameters[static_cast<std::size_t>(moving[static_cast<std::size_t>(j)])].prior;
        prior.is_known())
      all(slopes.rows() + j, j) = std::sqrt(variance) / prior.std;
  return all;
}

}  // namespace

ApproximationErrors errors_of(const Approximation& a, const Recorded& recorded) {
  ApproximationErrors result;
  const fit::Means& means = recorded.means;
  const Eigen::MatrixXd slope =
      a.subject->is_costly()
          ? a.slope
          : fit::Separable(*a.subject, *recorded.record, recorded.prepared, means, a.names)
                .jacobian(a.fit.values);
  std::vector<Eigen::Index> moving;
  for (std::size_t k = 0; k < a.names.size(); ++k)
    if (!a.fit.at_bound[k] && slope.col(static_cast<Eigen::Index>(k)).norm() > 0.0)
      moving.push_back(static_cast<Eigen::Index>(k));
  const auto count = static_cast<Eigen::Index>(a.names.size());
  result.covariance = Eigen::MatrixXd::Constant(count, count, unset);
  // How long what is left remembers: until its correlation first falls below 0.
  const Eigen::VectorXd& r = a.fit.residual;
  const double sum = memory_of(means, r);
  result.correlation_time = 0.5 * (sum - 1.0) * spacing_of(means);
  result.effective = static_cast<double>(r.size()) / sum;
  Eigen::VectorXd w(r.size());
  for (Eigen::Index i = 0; i < r.size(); ++i) w[i] = means.list[static_cast<std::size_t>(i)].weight;
  const double freedom =
      std::max(1.0, static_cast<double>(r.size() - static_cast<Eigen::Index>(moving.size())));
  result.variance = w.cwiseProduct(r).squaredNorm() / freedom * sum;
  if (moving.empty()) return result;
  Eigen::MatrixXd columns =
      with_priors(a, moving, result.variance, w.asDiagonal() * slope(Eigen::all, moving));
  const Eigen::VectorXd length = columns.colwise().norm();
  columns = columns * length.cwiseInverse().asDiagonal();
  const algebra::ThinSvd svd = algebra::thin_svd(columns);
  const Eigen::VectorXd& s = svd.values;
  result.condition = s[0] / s[s.size() - 1];
  const Eigen::VectorXd spread =
      Eigen::VectorXd::Constant(s.size(), result.variance) + coarseness(*a.subject, means, svd.U);
  const Eigen::MatrixXd v = svd.V * (spread.cwiseSqrt().cwiseQuotient(s)).asDiagonal();
  const Eigen::MatrixXd inner = v * v.transpose();
  for (std::size_t i = 0; i < moving.size(); ++i)
    for (std::size_t j = 0; j < moving.size(); ++j) {
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      result.covariance(moving[i], moving[j]) = inner(row, column) / (length[row] * length[column]);
    }
  return result;
}

}  // namespace raceway::tolerance
