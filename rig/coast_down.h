#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "record/record.h"

namespace raceway::rig {

/// Options for dividing a coast-down into windows. Each window gives one row. The defaults are
/// suitable for records with a few hundred to a million samples.
struct CoastDownOptions {
  int windows = 40;  ///< intended number of windows per run; more windows give noisier rows
  /// Smallest number of samples in a window. A window of 7 samples has 4 degrees of freedom for the
  /// noise.
  int fewest_samples = 7;
  /// Largest fall of the speed within a window, relative to the speed at the start of the window
  /// [1]. The last window, and a window with the smallest number of samples, may exceed this limit.
  double largest_fall = 0.25;
};

/// Result for one run of a coast-down.
struct CoastDownRun {
  std::string run;         ///< run_id; empty if the file has none
  int samples = 0;         ///< samples used; samples with the same time count as one
  int before_release = 0;  ///< excluded samples before the release: run-up and plateau
  int outliers = 0;        ///< samples excluded as outliers
  int rows = 0;            ///< number of rows, each with a torque
  /// Standard deviation of the noise in one speed sample, or in one block mean if the samples are
  /// averaged [rad/s].
  double speed_noise = unset;
  double correlation = 0.0;   ///< correlation of neighbouring residuals; 0 if not significant [1]
  double torque_std = unset;  ///< standard deviation of the torque, median over the rows [N m]
};

struct CoastDownTorque {
  /// Rows of friction torque with their standard deviation, which is treated as exact
  /// (Column::known), and the means of all recorded inputs. The notes describe all changes to the
  /// data.
  record::Record record;
  std::vector<CoastDownRun> runs;
};

/// Computes the friction torque of the rig from time and speed of a shaft that coasts down [N m]:
///
///   M = -J dω/dt
///
/// The method is local regression. Each run is divided into windows of consecutive samples that do
/// not overlap, so the errors of the rows are independent. A parabola in time is fitted to each
/// window. The slope and the value of the parabola at the mean time of the window give torque and
/// speed of one row. The slope of a parabola is not affected by the curvature of ω(t), even for
/// unequally spaced samples. For equal spacing, the slope of a parabola is as noisy as the slope of
/// a straight line. A window covers 1/`windows` of the run, because the noise falls with the 1.5th
/// power of the window length. A window is shorter if the speed would fall by more than
/// `largest_fall`. The remaining error comes from the third time derivative of the speed. For M ~
/// ω^p and a relative fall s of the speed, this error is the share p (2p - 1) s²/40 of the torque.
/// At s = 0.25, the share is 0.035 % for p = 2/3 and 0.94 % for p = 2.
///
/// The standard deviation of a row follows from the scatter of the residuals of the whole run
/// (robust estimate, Huber's proposal 2), propagated to the slope. If neighbouring residuals are
/// correlated (filtered signals), the standard deviation is larger: it is then computed for
/// first-order autoregressive noise. Samples that are more than 8 robust standard deviations away
/// from a robust local parabola are excluded. No window extends over a gap. Dense records are first
/// averaged in blocks, so that a window contains at most 32 blocks.
///
/// The line number of a row is the line in the middle of its window. The notes state how many
/// samples were excluded or averaged, and give the line number of the first such sample.
/// Domain:   constant inertia, no drive. The function excludes samples before the release
/// (release.h), samples at standstill or below Rig::minimum_speed, windows in which the shaft
/// speeds up, and runs with fewer samples than the smallest window. If the shaft is driven up again
/// within a run, the function uses each coast-down in the run. Samples with the same time are
/// averaged. Throws std::invalid_argument if the inertia is missing or not positive, for a value
/// that is not finite, for a time that decreases within a run (the message names the line), for
/// invalid options, and if no run gives a torque.
[[nodiscard]] CoastDownTorque coast_down_torque(const record::Record& coast_down,
                                                const model::Rig& rig,
                                                const CoastDownOptions& options = {});

}  // namespace raceway::rig
