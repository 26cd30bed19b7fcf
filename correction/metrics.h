#pragma once

#include <span>

#include "record/units.h"

namespace raceway::correction {

/// Errors of a simulated displacement, by the different definitions in papers. Residue: measured
/// minus simulated. All [SI] except percentages.
struct Metrics {
  std::size_t readings = 0;
  double rms = unset, mean_abs = unset, max_abs = unset;
  double residue_min = unset, residue_max = unset;
  /// |max| + |min| of the residue, as printed by [Transfer2022, eq. 7]. It is the peak-to-peak
  /// value where the two have different signs, and more where they have not.
  double peak_to_peak = unset;
  /// (1 - |y - s| / |y - mean of y|) 100, y measured: 100 is perfect, 0 no better than the mean.
  double fit_percent = unset;
  /// Reduction of the largest residue relative to the largest displacement [%].
  double reduction_of_max_percent = unset;
};

/// Rows in which either is NaN are left out.
[[nodiscard]] Metrics metrics(std::span<const double> measured, std::span<const double> simulated);

}  // namespace raceway::correction
