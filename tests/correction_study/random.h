#pragma once

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>

namespace correction_study {

/// Draws that are the same on every machine: the standard fixes the engine, not its distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between(double lower, double upper) {
    return boost::random::uniform_real_distribution<double>(lower, upper)(engine_);
  }
  int whole(int lower, int upper) {
    return boost::random::uniform_int_distribution<int>(lower, upper)(engine_);
  }
  double normal() { return boost::random::normal_distribution<double>()(engine_); }
  bool chance(double p) { return between(0.0, 1.0) < p; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }
  /// `value`, up to `share` more or less.
  double about(double value, double share = 0.25) {
    return value * between(1.0 - share, 1.0 + share);
  }
  template <typename Range>
  const auto& one_of(const Range& range) {
    return range[static_cast<std::size_t>(whole(0, static_cast<int>(std::size(range)) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace correction_study
