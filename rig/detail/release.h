#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rig/detail/speed_regression.h"

/// Finds the release of a shaft for coast_down_torque().
namespace raceway::rig {

/// Criteria for a release.
struct ReleaseOptions {
  std::size_t fewest = 7;    ///< smallest number of samples in a window
  std::size_t windows = 40;  ///< number of windows per run for the noise estimate
  /// largest fall of the speed within a window, relative to the speed at its start [1]
  double largest_fall = 0.25;
};

/// Divides a run into starts: a new start begins each time the shaft is driven up again. Each start
/// begins at the lowest speed before a rise by more than a tenth of the highest speed of the run;
/// noise does not cause such a rise.
[[nodiscard]] std::vector<std::span<const Block>> starts(std::span<const Block> samples);

/// Returns the number of samples of one start up to and including the release; 0 if the record
/// begins with the release.
///
/// The release is a kink of ω(t). Friction of a free shaft depends on its speed, so dω/dt does not
/// jump, but the torque of a drive ends abruptly. At every sample, two least-squares models are
/// compared. Both models use a window around this sample, in which the speed differs from the speed
/// of this sample by at most the share `largest_fall`. Several window lengths are tried. A window
/// has at least `fewest` samples after this sample, and at least 4 samples before it (fewer only if
/// it is one of the first four samples):
///
///   released   a line before, a separate parabola after: 5 parameters
///   free       one polynomial of degree five: 6 parameters
///
/// The sample is a release under two conditions. The sum of squares of the model `released` is
/// smaller by more than 40 times the variance of a sample. Before the sample, the speed rises, or
/// falls at most a tenth as fast as after the sample, within two standard deviations. The variance
/// is estimated in the part of the run in which the shaft certainly coasts. If neighbouring samples
/// have the correlation r, the variance is multiplied by (1 + r)/(1 - r). If the model `released`
/// has a larger residual, for example because the speed control of the drive oscillates, the
/// variance of this residual is used. The search is repeated on the remaining samples, so run-up
/// and plateau may have any shape.
///
/// Domain:   a fall that begins slowly is not treated as a plateau, because it has no kink. The
///           function finds a release only at a speed within `largest_fall` of the highest speed. A
///           brake, a seal or boundary friction at lower speed is not treated as a release. A
///           plateau hidden by noise is kept. Such a plateau shifts the first torques by at most a
///           few standard deviations. Records with more than 1000 samples are averaged first. In
///           these records, up to three thousandths of the samples after the release are also
///           excluded.
[[nodiscard]] std::size_t samples_before_release(std::span<const Block> samples,
                                                 const ReleaseOptions& options);

}  // namespace raceway::rig
