#include "rig/detail/release.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "algebra/detail/decompositions.h"
#include "record/median.h"

namespace raceway::rig {
namespace {

constexpr double evidence_limit = 40.0;   // variances of a sample
constexpr double driven_slope = 0.1;      // of the slope after the release
constexpr double rise_limit = 0.1;        // of the highest speed
constexpr std::size_t fewest_before = 4;  // where there are as many
constexpr std::size_t most_blocks = 1000;
constexpr std::size_t stride_share = 8;  // of a length: candidates that are looked at first

/// Medians of up to five samples, as many on both sides, so that a falling curve stays as it is.
std::vector<Block> without_spikes(std::span<const Block> samples) {
  std::vector<Block> clean(samples.begin(), samples.end());
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const std::size_t side = std::min({std::size_t{2}, i, samples.size() - 1 - i});
    std::array<double, 5> near{};
    const auto end = near.begin() + static_cast<std::ptrdiff_t>(2 * side + 1);
    std::transform(samples.begin() + static_cast<std::ptrdiff_t>(i - side),
                   samples.begin() + static_cast<std::ptrdiff_t>(i + side + 1), near.begin(),
                   [](const Block& b) { return b.speed; });
    const auto middle = near.begin() + static_cast<std::ptrdiff_t>(side);
    std::nth_element(near.begin(), middle, end);
    clean[i].speed = *middle;
  }
  return clean;
}

double highest_speed(std::span<const Block> blocks) {
  double highest = 0.0;
  for (const Block& b : blocks) highest = std::max(highest, b.speed);
  return highest;
}

/// A polynomial of time by least squares, about a knot.
class PolynomialFit {
 public:
  /// `count`: coefficients, up to 6.
  PolynomialFit(int count, const Block& knot, double scale)
      : count_(count),
        knot_(knot),
        scale_(scale),
        normal_(Eigen::MatrixXd::Zero(count, count)),
        right_(Eigen::VectorXd::Zero(count)) {}

  void add(std::span<const Block> blocks) {
    for (const Block& b : blocks) {
      const Powers f = powers(b);
      for (int j = 0; j < count_; ++j) {
        for (int i = j; i < count_; ++i) normal_(i, j) += f[i] * f[j];
        right_[j] += (b.speed - knot_.speed) * f[j];
      }
    }
  }
  void solve() {
    solver_.emplace(normal_);
    coefficients_ = solver_->solve(right_);
  }
  [[nodiscard]] double slope() const { return coefficients_[1] / scale_; }
  /// Variance of the slope where a sample has one of 1.
  [[nodiscard]] double slope_variance() const {
    return solver_->solve(Eigen::VectorXd::Unit(count_, 1))[1] / (scale_ * scale_);
  }
  [[nodiscard]] double squares(std::span<const Block> blocks) const {
    double sum = 0.0;
    for (const Block& b : blocks) {
      const Powers f = powers(b);
      double residual = b.speed - knot_.speed;
      for (int i = 0; i < count_; ++i) residual -= coefficients_[i] * f[i];
      sum += residual * residual;
    }
    return sum;
  }

 private:
  using Powers = Eigen::Matrix<double, 6, 1>;

  [[nodiscard]] Powers powers(const Block& b) const {
    const double u = (b.time - knot_.time) / scale_;
    Powers f;
    f[0] = 1.0;
    for (int i = 1; i < count_; ++i) f[i] = u * f[i - 1];
    return f;
  }

  int count_;
  const Block& knot_;
  double scale_;
  Eigen::MatrixXd normal_;
  Eigen::VectorXd right_, coefficients_;
  std::optional<algebra::SymmetricSolver> solver_;
};

/// A kink of the speed at one of the blocks.
struct Kink {
  std::size_t at = 0;
  std::size_t length = 0;  // blocks on either side that were looked at
  double evidence = 0.0;   // [variances of a sample]; 0 where it is no release
};

class ReleaseSearch {
 public:
  ReleaseSearch(std::span<const Block> blocks, const SpeedNoise& noise,
                const ReleaseOptions& options)
      : blocks_(blocks), options_(options), highest_(highest_speed(blocks)) {
    // Rounding is noise as well.
    variance_ = std::max(noise.std * noise.std, std::pow(1e-9 * highest_, 2));
    inflation_ = (1.0 + noise.correlation) / (1.0 - noise.correlation);
  }

  /// The last driven block, or nothing: evidence 0.
  [[nodiscard]] Kink find() const {
    Kink best;
    for (std::size_t length = fewest_before; length < 2 * blocks_.size(); length *= 2) {
      const std::size_t stride = std::max<std::size_t>(1, length / stride_share);
      for (std::size_t k = 2; k + options_.fewest < blocks_.size(); k += stride)
        keep_better(at(k, length), best);
    }
    if (best.evidence == 0.0) return best;
    const std::size_t around = best.length / stride_share;
    const std::size_t first = std::max(best.at, around + 2) - around;
    const std::size_t last = best.at + around, length = best.length;
    for (std::size_t k = first; k <= last && k + options_.fewest < blocks_.size(); ++k)
      keep_better(at(k, length), best);
    return best;
  }

 private:
  static void keep_better(const Kink& kink, Kink& best) {
    if (kink.evidence > best.evidence) best = kink;
  }

  [[nodiscard]] Kink at(std::size_t k, std::size_t length) const {
    Kink kink{.at = k, .length = length};
    const Block& knot = blocks_[k];
    if (knot.speed < (1.0 - options_.largest_fall) * highest_) return kink;
    const auto [before, after] = near(k, length);
    PolynomialFit held(2, knot, knot.time - before.front().time);
    PolynomialFit free(3, knot, after.back().time - knot.time);
    PolynomialFit smooth(6, knot,
                         std::max(knot.time - before.front().time, after.back().time - knot.time));
    held.add(before);
    free.add(after);
    smooth.add(before);
    smooth.add(after);
    held.solve();
    free.solve();
    smooth.solve();
    if (!(free.slope() < 0.0)) return kink;
    const double left = held.squares(before) + free.squares(after);
    const double freedom = static_cast<double>(before.size() + after.size()) - 5.0;
    const double variance = inflation_ * std::max(variance_, left / freedom);
    if (held.slope() + 2.0 * std::sqrt(variance * held.slope_variance()) <
        driven_slope * free.slope())
      return kink;
    const double evidence = (smooth.squares(before) + smooth.squares(after) - left) / variance;
    if (evidence > evidence_limit) kink.evidence = evidence;
    return kink;
  }

  /// Blocks before and after a knot over which the speed hardly changes; 4 before and `fewest`
  /// after it in any case.
  [[nodiscard]] std::pair<std::span<const Block>, std::span<const Block>> near(
      std::size_t k, std::size_t length) const {
    const double limit = options_.largest_fall * blocks_[k].speed;
    const auto is_near = [&](std::size_t i) {
      return std::abs(blocks_[i].speed - blocks_[k].speed) <= limit;
    };
    std::size_t first = k - std::min<std::size_t>(k, fewest_before), last = k + options_.fewest;
    while (first > 0 && k - first < length && is_near(first - 1)) --first;
    while (last + 1 < blocks_.size() && last - k < length && is_near(last + 1)) ++last;
    return {blocks_.subspan(first, k - first), blocks_.subspan(k + 1, last - k)};
  }

  std::span<const Block> blocks_;
  const ReleaseOptions& options_;
  double highest_, variance_ = 0.0, inflation_ = 1.0;
};

/// Of what certainly coasts, the end at which the speed is too low for a release, where that is
/// long enough.
SpeedNoise noise_of(std::span<const Block> blocks, const ReleaseOptions& options) {
  const double lowest_release = (1.0 - options.largest_fall) * highest_speed(blocks);
  std::size_t first = blocks.size();
  while (first > 0 && blocks[first - 1].speed < lowest_release) --first;
  if (blocks.size() - first < 4 * options.fewest) first = 0;
  const std::size_t most = std::max(options.fewest, blocks.size() / options.windows);
  std::vector<LocalParabola> fits, steep;  // over which a parabola is not the truth
  for (const std::span<const Block> part :
       windows(blocks.subspan(first), options.fewest, most, options.largest_fall))
    (part.back().speed < (1.0 - options.largest_fall) * part.front().speed ? steep : fits)
        .push_back(local_parabola(part));
  if (fits.empty()) fits = std::move(steep);
  return speed_noise(fits);
}

}  // namespace

std::vector<std::span<const Block>> starts(std::span<const Block> samples) {
  std::vector<std::span<const Block>> parts;
  const std::vector<Block> clean = without_spikes(samples);
  const double limit = rise_limit * highest_speed(clean);
  std::size_t first = 0, lowest = 0, highest = 0;
  bool falling = false;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    if (clean[i].speed > clean[highest].speed) highest = i;
    if (clean[i].speed < clean[lowest].speed) lowest = i;
    if (!falling && clean[i].speed < clean[highest].speed - limit) {
      falling = true;
      lowest = i;
    } else if (falling && clean[i].speed > clean[lowest].speed + limit) {
      parts.push_back(samples.subspan(first, lowest - first));
      first = lowest;
      highest = i;
      falling = false;
    }
  }
  parts.push_back(samples.subspan(first));
  return parts;
}

std::size_t samples_before_release(std::span<const Block> samples, const ReleaseOptions& options) {
  const std::vector<Block> clean = without_spikes(samples);
  const std::size_t size = (clean.size() + most_blocks - 1) / most_blocks;
  const std::vector<Block> blocks = size > 1 ? averaged(clean, size) : clean;
  if (blocks.size() <= options.fewest + 2) return 0;
  const SpeedNoise noise = noise_of(blocks, options);
  // What rises by more than noise does is driven up to the top.
  const auto top =
      std::max_element(blocks.begin(), blocks.end(),
                       [](const Block& a, const Block& b) { return a.speed < b.speed; });
  std::size_t driven = blocks.front().speed < (1.0 - rise_limit) * top->speed
                           ? static_cast<std::size_t>(top - blocks.begin())
                           : 0;
  while (blocks.size() - driven > options.fewest + 2) {
    const Kink kink = ReleaseSearch(std::span(blocks).subspan(driven), noise, options).find();
    if (kink.evidence == 0.0) break;
    driven += kink.at + 1;
  }
  if (driven == 0 || size <= 1) return driven;
  // The block after the kink may hold the release.
  return std::min(driven + 1, blocks.size()) * samples.size() / blocks.size();
}

}  // namespace raceway::rig
