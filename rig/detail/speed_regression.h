#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "record/channel.h"

/// The regression behind coast_down_torque().
namespace raceway::rig {

/// Inputs that a record may hold, in the order of the table of channels.
inline constexpr std::size_t input_count = [] {
  std::size_t count = 0;
  for (const record::Channel& c : record::channels) count += c.is_input() ? 1 : 0;
  return count;
}();

/// Mean of consecutive samples; a block of one is the sample itself.
struct Block {
  double time = 0.0;                         ///< [s]
  double speed = 0.0;                        ///< [rad/s]
  std::size_t row = 0;                       ///< of the record: the middle one
  std::array<double, input_count> inputs{};  ///< [SI]
};

/// A parabola by least squares through consecutive blocks, about their mean time.
struct LocalParabola {
  double time;                     // mean [s]
  double speed;                    // value there [rad/s]
  double slope;                    // there [rad/s²]
  Eigen::VectorXd residual;        // measured minus parabola [rad/s]
  Eigen::VectorXd slope_gain;      // slope = slope_gain · speeds [1/s]
  Eigen::MatrixXd residual_maker;  // residual = residual_maker · speeds [1]
};

/// Noise of one run: standard deviation and first-order autocorrelation of the speed samples.
struct SpeedNoise {
  double std;
  double correlation;
};

[[nodiscard]] LocalParabola local_parabola(std::span<const Block> blocks);

/// Marks samples far from a robust local parabola, in deviations of their part (of about `length`
/// samples) or of the whole run, whichever is larger: a short part may look too good, a curved one
/// has more than noise.
[[nodiscard]] std::vector<bool> find_outliers(std::span<const Block> samples, std::size_t length);

/// Means of about `length` samples each.
[[nodiscard]] std::vector<Block> averaged(std::span<const Block> samples, std::size_t length);

/// Cuts at gaps of more than `limit` usual spacings. Spacing may drift (samples per revolution), so
/// it is judged against neighbours.
[[nodiscard]] std::vector<std::span<const Block>> segments(std::span<const Block> samples,
                                                           double limit);

/// Cuts a segment into windows of `fewest` to `most` blocks, over which the speed falls by no more
/// than `largest_fall`. What is too short at the end goes to the last window.
[[nodiscard]] std::vector<std::span<const Block>> windows(std::span<const Block> segment,
                                                          std::size_t fewest, std::size_t most,
                                                          double largest_fall);

[[nodiscard]] SpeedNoise speed_noise(const std::vector<LocalParabola>& fits);

/// Standard deviation of the slope of a fit under that noise [rad/s²].
[[nodiscard]] double slope_deviation(const LocalParabola& fit, const SpeedNoise& noise);

}  // namespace raceway::rig
