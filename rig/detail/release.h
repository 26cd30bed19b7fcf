#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rig/detail/speed_regression.h"

/// Detection of the release of a shaft; used by coast_down_torque().
namespace raceway::rig {

/// Criteria for a release.
struct ReleaseOptions {
  std::size_t fewest = 7;      ///< samples of a window
  std::size_t windows = 40;    ///< of a run, from which the noise is estimated
  double largest_fall = 0.25;  ///< of the speed within a window, relative to its start [1]
};

/// Cuts a run where the shaft is driven up again: each part begins at the lowest speed before a
/// rise by more than a tenth of the highest speed of the run, which noise does not reach.
[[nodiscard]] std::vector<std::span<const Block>> starts(std::span<const Block> samples);

/// Number of samples of one start before the shaft was let go, the release included; 0 where the
/// record begins with the release.
///
/// A release is a kink of ω(t): what slows a free shaft depends on its speed, so dω/dt does not
/// jump, while a drive that holds or raises the speed ends at once. At every sample two models of
/// the samples before and after it, 4 and `fewest` or more, over which the speed changes by no more
/// than `largest_fall`, are compared by least squares:
///
///   released   a line before, a parabola after, not joined: 5 numbers
///   free       one polynomial of degree five: 6 numbers
///
/// It is a release where the first is nearer by more than 40 times the variance of a sample and the
/// slope before it is, within two deviations, no steeper than a tenth of that after it. The
/// variance is that of the part which coasts for certain (times (1 + r)/(1 - r) where neighbours
/// correlate by r), or what the first model leaves where that is more, as of a drive that hunts.
/// The search is repeated on the remaining samples, so that run-up and plateau may have any form.
///
/// Domain:   a fall that begins slowly is no plateau, however slow, as it has no kink. The release
///           stands within `largest_fall` of the highest speed: a brake, a seal or boundary
///           friction further down is none. A plateau that the noise hides is kept; it shifts the
///           first torques by no more than some standard deviations. Of more than 1000 samples
///           means are taken; then up to three thousandths of the samples behind the release go as
///           well.
[[nodiscard]] std::size_t samples_before_release(std::span<const Block> samples,
                                                 const ReleaseOptions& options);

}  // namespace raceway::rig
