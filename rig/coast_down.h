#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "record/record.h"

namespace raceway::rig {

/// Options for dividing a coast-down into windows. Each window gives one row of the result. The
/// defaults are suitable for records with a few hundred to a million samples.
struct CoastDownOptions {
  /// Number of windows into which a run is divided, >= 1. The actual number is larger if
  /// `largest_fall` makes the windows shorter, and smaller if `fewest_samples` makes the windows
  /// longer. More windows give noisier rows.
  int windows = 40;
  /// Smallest number of samples in a window, >= 5. The parabola of a window has 3 coefficients, so
  /// 7 samples leave 4 degrees of freedom for the noise.
  int fewest_samples = 7;
  /// Largest fall of the speed within a window, relative to the speed at the start of the window
  /// [1], between 0 and 1. The last window and a window of `fewest_samples` samples may exceed this
  /// limit.
  double largest_fall = 0.25;
};

/// Result for one run of a coast-down.
struct CoastDownRun {
  std::string run;         ///< run_id; empty if the file has none
  int samples = 0;         ///< samples used; samples with the same time count as one
  int before_release = 0;  ///< excluded samples before the release: run-up and plateau
  int outliers = 0;        ///< samples excluded as outliers
  int rows = 0;            ///< number of rows, each with a torque
  /// Standard deviation of the noise of one speed sample [rad/s]. If the samples were averaged in
  /// blocks, the value applies to the mean of a block.
  double speed_noise = unset;
  double correlation = 0.0;   ///< correlation of neighbouring residuals; 0 if not significant [1]
  double torque_std = unset;  ///< standard deviation of the torque, median over the rows [N m]
};

struct CoastDownTorque {
  /// One row for each window, with the friction torque, its standard deviation and the means of all
  /// recorded inputs. A later fit treats the standard deviation as exact (Column::known). The notes
  /// describe all changes to the data, such as excluded samples.
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
/// speed of one row. The curvature of ω(t) does not bias the slope of a parabola, even for
/// unequally spaced samples. For equal spacing, the slope of a parabola is as noisy as the slope of
/// a straight line. A window covers 1/`windows` of the run, or less if the speed would fall by more
/// than `largest_fall`. The standard deviation of a torque is proportional to the window length to
/// the power -1.5. The systematic error of a torque comes from the third time derivative of the
/// speed. For M ~ ω^p and a relative fall s of the speed within a window, this error is p (2p - 1)
/// s²/40 times the torque. At s = 0.25, this is 0.035 % for p = 2/3 and 0.94 % for p = 2.
///
/// The standard deviation of a torque follows from the scatter of the residuals of the whole run
/// (robust estimate, Huber's proposal 2). If neighbouring residuals are correlated, as in a
/// filtered signal, the function assumes first-order autoregressive noise, and the standard
/// deviation becomes larger. Samples that are more than 8 robust standard deviations away from a
/// robust local parabola are excluded as outliers. No window extends over a gap in time. Dense
/// records are first averaged in blocks, so that a window contains at most 32 blocks.
///
/// The line number of a row is the line number of the sample in the middle of its window. The notes
/// state how many samples were excluded or averaged, and give the lines of the first of these
/// samples.
/// Domain:   constant inertia, no drive. The function excludes samples before the drive is
///           released, and samples at standstill or below Rig::minimum_speed. The function also
///           excludes windows in which the speed does not fall, and runs with fewer than
///           `fewest_samples` samples. If the shaft is driven up again within a run, the function
///           uses each coast-down in the run. Samples with the same time are averaged. Throws
///           std::invalid_argument if the inertia is missing or not positive, for invalid options,
///           and for a time or speed that is not finite. Also throws std::invalid_argument if no
///           run gives a torque, and if the time decreases within a run. For a decreasing time, the
///           message gives the line.
[[nodiscard]] CoastDownTorque coast_down_torque(const record::Record& coast_down,
                                                const model::Rig& rig,
                                                const CoastDownOptions& options = {});

}  // namespace raceway::rig
