#include "rig/detail/speed_regression.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/detail/decompositions.h"
#include "record/median.h"

namespace raceway::rig {
namespace {

constexpr double outlier_limit = 8.0;  // robust deviations

/// Standard deviation from the median magnitude, for residuals of which less than half are bad.
double robust_deviation(const Eigen::VectorXd& residuals) {
  const Eigen::VectorXd magnitude = residuals.cwiseAbs();
  return 1.4826 * record::median({magnitude.begin(), magnitude.end()});
}

Eigen::MatrixXd powers_of_time(std::span<const Block> blocks, double origin, double scale) {
  Eigen::MatrixXd powers(static_cast<Eigen::Index>(blocks.size()), 3);
  for (Eigen::Index i = 0; i < powers.rows(); ++i) {
    const double u = (blocks[static_cast<std::size_t>(i)].time - origin) / scale;
    powers.row(i) << 1.0, u, u * u;
  }
  return powers;
}

double mean_time(std::span<const Block> blocks) {
  double sum = 0.0;
  for (const Block& b : blocks) sum += b.time;
  return sum / static_cast<double>(blocks.size());
}

Eigen::VectorXd speeds_of(std::span<const Block> blocks) {
  Eigen::VectorXd speeds(static_cast<Eigen::Index>(blocks.size()));
  for (std::size_t i = 0; i < blocks.size(); ++i)
    speeds[static_cast<Eigen::Index>(i)] = blocks[i].speed;
  return speeds;
}

/// Residuals of a parabola that outliers do not bend: bisquare weights, started from the median.
Eigen::VectorXd robust_residuals(std::span<const Block> samples) {
  const Eigen::MatrixXd powers =
      powers_of_time(samples, mean_time(samples), samples.back().time - samples.front().time);
  const Eigen::VectorXd speeds = speeds_of(samples);
  Eigen::Vector3d c(record::median({speeds.begin(), speeds.end()}), 0.0, 0.0);
  Eigen::VectorXd residual = speeds - powers * c;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double scale = std::max(robust_deviation(residual), 1e-9 * speeds.maxCoeff());
    const Eigen::ArrayXd u = residual.array() / (6.0 * scale);
    const Eigen::VectorXd root = (u.abs() < 1.0).select(1.0 - u.square(), 0.0).matrix();
    c = algebra::least_squares(root.asDiagonal() * powers, root.asDiagonal() * speeds);
    residual = speeds - powers * c;
  }
  return residual;
}

/// Standard deviation of residuals that are mostly Gaussian: Huber's proposal 2 at k = 2.5, 99 %
/// efficient without outliers. Residuals come divided by sqrt(1 - leverage).
double robust_scale(const std::vector<double>& residuals) {
  constexpr double k = 2.5;
  const double phi = std::exp(-0.5 * k * k) / std::sqrt(2.0 * pi);
  const double tail = 0.5 * std::erfc(k / std::sqrt(2.0));
  const double expected = 1.0 - 2.0 * tail - 2.0 * k * phi + 2.0 * k * k * tail;
  double square = 0.0;
  for (const double e : residuals) square += e * e;
  square /= static_cast<double>(residuals.size());
  for (int iteration = 0; iteration < 100 && square > 0.0; ++iteration) {
    double sum = 0.0;
    for (const double e : residuals) sum += std::min(e * e / square, k * k);
    const double next = square * sum / (static_cast<double>(residuals.size()) * expected);
    const bool done = std::abs(next - square) <= 1e-10 * square;
    square = next;
    if (done) break;
  }
  return std::sqrt(square);
}

Eigen::MatrixXd correlation_matrix(Eigen::Index size, double correlation) {
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      matrix(i, j) = std::pow(correlation, static_cast<double>(std::abs(i - j)));
  return matrix;
}

/// What the residuals of fits tell of the correlation of neighbours. A fit leaves residuals that
/// are correlated even if the noise is not: with residual maker P and neighbours summed by A,
///
///   E[e'Ae] = tr(A P R P),   E[e'e] = tr(P R P)   for noise of correlation R
///
/// and the correlation is the one whose expected ratio is the ratio found.
class NeighbourCorrelation {
 public:
  /// `scale`: beyond 2.5 of it residuals are cut.
  NeighbourCorrelation(const std::vector<LocalParabola>& fits, double scale) {
    for (const LocalParabola& fit : fits) {
      const Eigen::MatrixXd& p = fit.residual_maker;
      const Eigen::Index n = fit.residual.size();
      Eigen::VectorXd e(n);
      for (Eigen::Index i = 0; i < n; ++i) {
        const double limit = 2.5 * scale * std::sqrt(p(i, i));
        e[i] = std::clamp(fit.residual[i], -limit, limit);
      }
      product_ += e.head(n - 1).dot(e.tail(n - 1));
      square_ += e.squaredNorm();
      count_ += static_cast<double>(n);
      neighbour_.push_back(p.topRows(n - 1).transpose() * p.bottomRows(n - 1));
      plain_.push_back(p);  // P'P = P
    }
  }

  /// Only a correlation beyond twice its own scatter is believed.
  [[nodiscard]] bool significant() const {
    return !(product_ / square_ - ratio(0.0) < 2.0 / std::sqrt(count_));
  }
  [[nodiscard]] double find() const {
    double low = 0.0, high = 0.95;
    for (int iteration = 0; iteration < 40; ++iteration) {
      const double middle = 0.5 * (low + high);
      (ratio(middle) < product_ / square_ ? low : high) = middle;
    }
    return low;
  }
  /// tr(A P R P) and tr(P R P).
  [[nodiscard]] std::pair<double, double> expected(double correlation) const {
    double numerator = 0.0, denominator = 0.0;
    for (std::size_t w = 0; w < plain_.size(); ++w) {
      const Eigen::MatrixXd r = correlation_matrix(plain_[w].rows(), correlation);
      numerator += neighbour_[w].cwiseProduct(r).sum();
      denominator += plain_[w].cwiseProduct(r).sum();
    }
    return {numerator, denominator};
  }

 private:
  [[nodiscard]] double ratio(double correlation) const {
    const auto [numerator, denominator] = expected(correlation);
    return numerator / denominator;
  }

  double product_ = 0.0, square_ = 0.0, count_ = 0.0;
  std::vector<Eigen::MatrixXd> neighbour_, plain_;
};

}  // namespace

LocalParabola local_parabola(std::span<const Block> blocks) {
  const double origin = mean_time(blocks);
  const double scale = blocks.back().time - blocks.front().time;
  const Eigen::MatrixXd powers = powers_of_time(blocks, origin, scale);
  const Eigen::VectorXd speeds = speeds_of(blocks);
  const algebra::HouseholderQr qr(powers);
  const Eigen::MatrixXd inverse = qr.inverse_R() * qr.Q().transpose();
  const Eigen::Vector3d c = inverse * speeds;
  LocalParabola fit;
  fit.time = origin;
  fit.speed = c[0];
  fit.slope = c[1] / scale;
  fit.slope_gain = inverse.row(1).transpose() / scale;
  fit.residual = speeds - powers * c;
  fit.residual_maker = -powers * inverse;
  fit.residual_maker.diagonal().array() += 1.0;
  return fit;
}

std::vector<bool> find_outliers(std::span<const Block> samples, std::size_t length) {
  const std::size_t parts = std::max<std::size_t>(1, samples.size() / length);
  std::vector<Eigen::VectorXd> residuals;
  std::vector<double> scales;
  for (std::size_t k = 0; k < parts; ++k) {
    const std::size_t first = k * samples.size() / parts, last = (k + 1) * samples.size() / parts;
    residuals.push_back(robust_residuals(samples.subspan(first, last - first)));
    scales.push_back(robust_deviation(residuals.back()));
  }
  const double usual = record::median(scales);
  const double floor = 1e-9 * samples.front().speed;
  std::vector<bool> outlier;
  outlier.reserve(samples.size());
  for (std::size_t k = 0; k < parts; ++k)
    for (const double e : residuals[k])
      outlier.push_back(std::abs(e) > outlier_limit * std::max({scales[k], usual, floor}));
  return outlier;
}

std::vector<Block> averaged(std::span<const Block> samples, std::size_t length) {
  std::vector<Block> blocks;
  const std::size_t count = std::max<std::size_t>(1, samples.size() / length);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t first = k * samples.size() / count, last = (k + 1) * samples.size() / count;
    const Block& origin = samples[first];  // summed from here, so what is constant stays exact
    const double share = 1.0 / static_cast<double>(last - first);
    Block mean = origin;
    for (std::size_t i = first; i < last; ++i) {
      const Block& s = samples[i];
      mean.time += share * (s.time - origin.time);
      mean.speed += share * (s.speed - origin.speed);
      for (std::size_t c = 0; c < input_count; ++c)
        mean.inputs[c] += share * (s.inputs[c] - origin.inputs[c]);
    }
    mean.row = samples[(first + last) / 2].row;
    blocks.push_back(mean);
  }
  return blocks;
}

std::vector<std::span<const Block>> segments(std::span<const Block> samples, double limit) {
  std::vector<std::span<const Block>> parts;
  std::size_t first = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const std::size_t from = i > 6 ? i - 6 : 1, to = std::min(samples.size() - 1, i + 6);
    std::vector<double> spacing;
    for (std::size_t k = from; k <= to; ++k)
      spacing.push_back(samples[k].time - samples[k - 1].time);
    if (samples[i].time - samples[i - 1].time > limit * record::median(std::move(spacing))) {
      parts.push_back(samples.subspan(first, i - first));
      first = i;
    }
  }
  parts.push_back(samples.subspan(first));
  return parts;
}

std::vector<std::span<const Block>> windows(std::span<const Block> segment, std::size_t fewest,
                                            std::size_t most, double largest_fall) {
  std::vector<std::span<const Block>> parts;
  std::size_t first = 0;
  while (segment.size() - first >= fewest) {
    std::size_t last = first + fewest;
    while (last < segment.size() && last - first < most &&
           segment[last].speed > (1.0 - largest_fall) * segment[first].speed)
      ++last;
    if (segment.size() - last < fewest) last = segment.size();
    parts.push_back(segment.subspan(first, last - first));
    first = last;
  }
  return parts;
}

SpeedNoise speed_noise(const std::vector<LocalParabola>& fits) {
  std::vector<double> standardised;
  for (const LocalParabola& fit : fits)
    for (Eigen::Index i = 0; i < fit.residual.size(); ++i)
      standardised.push_back(fit.residual[i] / std::sqrt(fit.residual_maker(i, i)));
  const double scale = robust_scale(standardised);
  if (!(scale > 0.0)) return {.std = 0.0, .correlation = 0.0};
  const NeighbourCorrelation neighbours(fits, scale);
  if (!neighbours.significant()) return {.std = scale, .correlation = 0.0};
  const double white = neighbours.expected(0.0).second;
  const double correlation = neighbours.find();
  return {.std = scale * std::sqrt(white / neighbours.expected(correlation).second),
          .correlation = correlation};
}

double slope_deviation(const LocalParabola& fit, const SpeedNoise& noise) {
  const Eigen::VectorXd& gain = fit.slope_gain;
  return noise.std * std::sqrt(gain.dot(correlation_matrix(gain.size(), noise.correlation) * gain));
}

}  // namespace raceway::rig
