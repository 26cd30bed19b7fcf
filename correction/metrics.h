#pragma once

#include <span>

#include "record/units.h"

namespace raceway::correction {

/// Errors of a simulated displacement, with the definitions of several papers. The residue is the
/// measured minus the simulated displacement. Values are in SI units, except percentages.
struct Metrics {
  std::size_t readings = 0;
  double rms = unset, mean_abs = unset, max_abs = unset;
  double residue_min = unset, residue_max = unset;
  /// |max| + |min| of the residue, as printed in [Transfer2022, eq. 7]. This sum equals the
  /// peak-to-peak value if max and min have different signs; otherwise it is larger.
  double peak_to_peak = unset;
  /// (1 - |y - s| / |y - mean of y|) 100 with the measured y: 100 means a perfect simulation, and 0
  /// means that the mean would be as good.
  double fit_percent = unset;
  /// Reduction of the largest error: (1 - largest |residue| / largest |measured displacement|) 100.
  double reduction_of_max_percent = unset;
};

/// Computes the errors. Rows in which one of the two values is NaN are left out.
[[nodiscard]] Metrics metrics(std::span<const double> measured, std::span<const double> simulated);

}  // namespace raceway::correction
