#pragma once

#include <span>

#include "record/units.h"

namespace raceway::correction {

/// Errors of a simulated displacement, as defined in several papers. These papers use the term
/// residue for the residual, which is the measured minus the simulated displacement. Values are in
/// m (angles: rad), except percentages.
struct Metrics {
  std::size_t readings = 0;
  double rms = unset, mean_abs = unset, max_abs = unset;
  double residue_min = unset, residue_max = unset;
  /// |residue_max| + |residue_min|, as printed in [Transfer2022, eq. 7]. This sum is the
  /// peak-to-peak residue if residue_max and residue_min have different signs; otherwise the sum is
  /// larger.
  double peak_to_peak = unset;
  /// Agreement in percent: (1 - |y - s| / |y - mean of y|) 100. y contains the measured values, s
  /// the simulated values, and |.| is the Euclidean norm. The value is 100 for a perfect
  /// simulation. The value is 0 if the simulation has the same rms error as a constant equal to the
  /// mean of y.
  double fit_percent = unset;
  /// Reduction of the largest displacement by a correction, in percent: (1 - largest |residue| /
  /// largest |measured displacement|) 100.
  double reduction_of_max_percent = unset;
};

/// Computes the errors. Rows in which the measured or the simulated value is NaN are left out.
[[nodiscard]] Metrics metrics(std::span<const double> measured, std::span<const double> simulated);

}  // namespace raceway::correction
