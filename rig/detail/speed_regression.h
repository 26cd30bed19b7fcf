#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "record/channel.h"

/// Regression of the speed for coast_down_torque().
namespace raceway::rig {

/// Number of inputs that a record may contain. Block::inputs has the order of record::channels.
inline constexpr std::size_t input_count = [] {
  std::size_t count = 0;
  for (const record::Channel& c : record::channels) count += c.is_input() ? 1 : 0;
  return count;
}();

/// Mean of consecutive samples. A block may contain a single sample.
struct Block {
  double time = 0.0;                         ///< [s]
  double speed = 0.0;                        ///< [rad/s]
  std::size_t row = 0;                       ///< middle row of the block in the record
  std::array<double, input_count> inputs{};  ///< mean of each input [SI]; NaN if not recorded
};

/// Least-squares parabola through consecutive blocks, about their mean time.
struct LocalParabola {
  double time;                     // mean [s]
  double speed;                    // value of the parabola at the mean time [rad/s]
  double slope;                    // slope of the parabola at the mean time [rad/s²]
  Eigen::VectorXd residual;        // measured value minus parabola [rad/s]
  Eigen::VectorXd slope_gain;      // slope = slope_gain · speeds [1/s]
  Eigen::MatrixXd residual_maker;  // residual = residual_maker · speeds [1]
};

/// Noise of one run: standard deviation [rad/s] and first-order autocorrelation [1] of the speed
/// samples.
struct SpeedNoise {
  double std;
  double correlation;
};

[[nodiscard]] LocalParabola local_parabola(std::span<const Block> blocks);

/// Returns true for samples far from a robust local parabola. The run is divided into parts of
/// about `length` samples. The limit is proportional to the standard deviation of the part, or to
/// the median of the standard deviations of all parts if this median is larger. A short part can
/// have a small standard deviation by chance.
[[nodiscard]] std::vector<bool> find_outliers(std::span<const Block> samples, std::size_t length);

/// Returns means of about `length` samples each.
[[nodiscard]] std::vector<Block> averaged(std::span<const Block> samples, std::size_t length);

/// Divides the samples at gaps longer than `limit` usual sampling intervals. The interval may
/// change slowly, for example with a fixed number of samples per revolution. Each interval is
/// therefore compared with neighbouring intervals.
[[nodiscard]] std::vector<std::span<const Block>> segments(std::span<const Block> samples,
                                                           double limit);

/// Divides a segment into windows of `fewest` to `most` blocks, in which the speed falls by at most
/// `largest_fall`. A remainder that is too short is added to the last window.
[[nodiscard]] std::vector<std::span<const Block>> windows(std::span<const Block> segment,
                                                          std::size_t fewest, std::size_t most,
                                                          double largest_fall);

[[nodiscard]] SpeedNoise speed_noise(const std::vector<LocalParabola>& fits);

/// Returns the standard deviation of the slope of a fit for this noise [rad/s²].
[[nodiscard]] double slope_deviation(const LocalParabola& fit, const SpeedNoise& noise);

}  // namespace raceway::rig
