#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "record/record.h"

namespace raceway::rig {

/// Settings for cutting a coast-down into rows. The defaults suit records of some hundred to a
/// million samples.
struct CoastDownOptions {
  int windows = 40;            ///< aimed at per run; more windows, more rows with more noise each
  int fewest_samples = 7;      ///< of a window; fewer leave less than four to judge the noise by
  double largest_fall = 0.25;  ///< of the speed within a window, relative to its start [1]
};

/// Result for one run of a coast-down.
struct CoastDownRun {
  std::string run;             ///< run_id, empty where the file has none
  int samples = 0;             ///< used; samples of one time count as one
  int before_release = 0;      ///< left out: run-up, plateau
  int outliers = 0;            ///< left out
  int rows = 0;                ///< torques gained
  double speed_noise = unset;  ///< standard deviation of one sample (or block mean) [rad/s]
  double correlation = 0.0;    ///< of neighbouring residuals, 0 where not significant [1]
  double torque_std = unset;   ///< median over the rows [N m]
};

struct CoastDownTorque {
  /// Rows of friction torque with their standard deviation, `known`, and the means of all inputs
  /// that the coast-down has; what was done is in the notes.
  record::Record record;
  std::vector<CoastDownRun> runs;
};

/// Friction torque of the rig from a record of time and speed of a shaft that coasts down [N m]:
///
///   M = -J dω/dt
///
/// by local regression: each run is cut into windows of consecutive samples that do not overlap, so
/// the errors of the rows are independent; in each a parabola in time is fitted, and slope and
/// value at the mean time of the window make one row. A parabola, because its slope is free of the
/// curvature of ω(t) also where samples are unequally spaced; at equal spacing it is no noisier
/// than a straight line. A window is as long as 1/`windows` of the run (noise falls with the 1.5th
/// power of the length), but shorter where the speed would fall by more than `largest_fall` in it:
/// the remaining error comes from the third derivative, which for M ~ ω^p shifts the torque by p
/// (2p - 1) s²/40 of itself at a relative fall s, 0.04 % for p = 2/3 and 1 % for p = 2 at s = 0.25.
///
/// Standard deviation of a row: residual scale of the whole run (robust, Huber's proposal 2) times
/// the gain of the slope, widened where neighbouring residuals are correlated (filtered signals),
/// as a first-order autoregression. Samples further than 8 robust deviations from a robust local
/// parabola are left out and named in the notes; windows do not span gaps. Dense records are
/// averaged in blocks first, at most 32 to a window.
///
/// A row stands for the line in the middle of its window. The notes list the samples that were left
/// out or averaged, with their place.
/// Domain:   constant inertia, no drive. Left out are samples before the release (release.h), at
///           standstill or below Rig::minimum_speed, windows in which the shaft speeds up, and a
///           run with fewer samples than a window needs. Where a run is driven up again it coasts
///           down more than once. Samples of one time are averaged.
/// Throws std::invalid_argument: no inertia, a value that is not finite, time that goes back within
/// a run (names the line), no run that is long enough.
[[nodiscard]] CoastDownTorque coast_down_torque(const record::Record& coast_down,
                                                const model::Rig& rig,
                                                const CoastDownOptions& options = {});

}  // namespace raceway::rig
