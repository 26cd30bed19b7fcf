#include "fit/sobol_indices.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace raceway::fit {
namespace {

constexpr std::size_t most_inputs = 1800;  // the table of Joe and Kuo in Boost has 3667 dimensions
constexpr std::size_t most_samples = std::size_t{1} << 24U;
constexpr std::size_t resamplings = 200;
constexpr double two_sided = 1.959963984540;  // of a normal law, 95 %

std::uint32_t reversed(std::uint32_t x) {
  x = ((x >> 1U) & 0x55555555U) | ((x & 0x55555555U) << 1U);
  x = ((x >> 2U) & 0x33333333U) | ((x & 0x33333333U) << 2U);
  x = ((x >> 4U) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4U);
  x = ((x >> 8U) & 0x00ff00ffU) | ((x & 0x00ff00ffU) << 8U);
  return (x >> 16U) | (x << 16U);
}

/// Every bit is turned or not by those above it alone: the scrambling of Owen.
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
  x = reversed(x);
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16U) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return reversed(x);
}

/// The sums of one resampling, each sample so many times as it was drawn.
struct Sums {
  explicit Sums(std::size_t inputs) : first(inputs, 0.0), total(inputs, 0.0) {}
  void add(double weight, const double* row, double mean) {
    const double a = row[0] - mean, b = row[1] - mean;
    count += weight;
    sum += weight * (a + b);
    squares += weight * (a * a + b * b);
    for (std::size_t i = 0; i < first.size(); ++i) {
      const double step = row[2 + i] - row[0];
      first[i] += weight * b * step;
      total[i] += weight * step * step;
    }
  }
  /// Of f over both sets.
  [[nodiscard]] double variance() const {
    const double mean = sum / (2.0 * count);
    return squares / (2.0 * count) - mean * mean;
  }

  double count = 0.0, sum = 0.0, squares = 0.0;
  std::vector<double> first, total;
};

}  // namespace

SobolDesign::SobolDesign(std::size_t inputs, std::size_t samples, std::uint64_t seed)
    : inputs_(inputs), samples_(samples) {
  if (inputs == 0 || inputs > most_inputs)
    throw std::invalid_argument("inputs = " + std::to_string(inputs) + ": must be from 1 to " +
                                std::to_string(most_inputs));
  if (samples < 2 || samples > most_samples || (samples & (samples - 1)) != 0)
    throw std::invalid_argument("samples = " + std::to_string(samples) +
                                ": must be a power of two from 2 to " +
                                std::to_string(most_samples));
  const std::size_t dimensions = 2 * inputs;
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> seeds(dimensions);
  for (std::uint32_t& one : seeds) one = static_cast<std::uint32_t>(random() >> 32U);
  boost::random::sobol_engine<std::uint_least32_t, 32U> engine(dimensions);
  points_.resize(samples * dimensions);
  // The engine leaves the first point out, the corner; without it no power of two fills evenly.
  for (std::size_t d = 0; d < dimensions; ++d) points_[d] = scrambled(0, seeds[d]);
  for (std::size_t k = 1; k < samples; ++k)
    for (std::size_t d = 0; d < dimensions; ++d)
      points_[k * dimensions + d] = scrambled(engine(), seeds[d]);
}

void SobolDesign::point(std::size_t evaluation, std::span<double> point) const {
  const std::size_t set = evaluation % (inputs_ + 2);
  const std::uint32_t* const row = &points_[evaluation / (inputs_ + 2) * 2 * inputs_];
  for (std::size_t i = 0; i < inputs_; ++i) {
    const bool of_b = set == 1 || set == i + 2;
    point[i] = std::ldexp(static_cast<double>(row[of_b ? inputs_ + i : i]), -32);
  }
}

SobolIndices sobol_indices(const SobolDesign& design, std::span<const double> values,
                           std::uint64_t seed) {
  if (values.size() != design.evaluations())
    throw std::invalid_argument(
        "values: must contain one value for each evaluation of the Sobol design");
  const std::size_t inputs = design.inputs(), width = inputs + 2;
  SobolIndices result;
  result.inputs.resize(inputs);
  std::vector<const double*> rows;
  double mean = 0.0;
  for (std::size_t k = 0; k < design.samples(); ++k) {
    const auto row = values.subspan(k * width, width);
    if (!std::all_of(row.begin(), row.end(), [](double v) { return std::isfinite(v); })) continue;
    rows.push_back(row.data());
    mean += row[0] + row[1];
  }
  result.complete = rows.size();
  if (rows.size() < 2) return result;
  mean /= 2.0 * static_cast<double>(rows.size());
  result.mean = mean;
  Sums all(inputs);
  for (const double* row : rows) all.add(1.0, row, mean);
  const double variance = std::fmax(all.variance(), 0.0);
  result.std = std::sqrt(variance);
  // Less than the rounding of the values is no variance.
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  if (!(result.std > rounding * std::fabs(mean))) return result;
  for (std::size_t i = 0; i < inputs; ++i) {
    result.inputs[i].first = all.first[i] / (all.count * variance);
    result.inputs[i].total = all.total[i] / (2.0 * all.count * variance);
  }
  std::mt19937_64 random(seed);
  std::vector<double> first(inputs, 0.0), first_2(inputs, 0.0), total(inputs, 0.0),
      total_2(inputs, 0.0);
  std::size_t made = 0;
  std::vector<std::uint32_t> drawn(rows.size());
  for (std::size_t b = 0; b < resamplings; ++b) {
    std::fill(drawn.begin(), drawn.end(), 0U);
    // 32 random bits over at most 2^24 rows: their bias is far below the scatter.
    for (std::size_t k = 0; k < rows.size(); ++k) ++drawn[((random() >> 32U) * rows.size()) >> 32U];
    Sums some(inputs);
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (drawn[k] > 0) some.add(drawn[k], rows[k], mean);
    const double v = some.variance();
    if (!(v > 0.0)) continue;
    ++made;
    for (std::size_t i = 0; i < inputs; ++i) {
      const double s = some.first[i] / (some.count * v) - result.inputs[i].first;
      const double t = some.total[i] / (2.0 * some.count * v) - result.inputs[i].total;
      first[i] += s;
      first_2[i] += s * s;
      total[i] += t;
      total_2[i] += t * t;
    }
  }
  const double n = static_cast<double>(made);
  const auto half_width = [n](double sum, double squares) {
    return n < 2.0 ? unset
                   : two_sided * std::sqrt(std::fmax(squares - sum * sum / n, 0.0) / (n - 1.0));
  };
  for (std::size_t i = 0; i < inputs; ++i) {
    result.inputs[i].first_error = half_width(first[i], first_2[i]);
    result.inputs[i].total_error = half_width(total[i], total_2[i]);
  }
  return result;
}

}  // namespace raceway::fit
