#pragma once

#include <span>
#include <vector>

#include "verdict/compare.h"

namespace raceway::verdict {

/// One cell of a MisfitMap: mean residual of the rows in one range of the horizontal axis and one
/// range of the vertical axis.
struct MisfitCell {
  std::size_t across = 0, up = 0;  ///< indices in MisfitMap::across and MisfitMap::up
  int rows = 0;
  double bias = unset;    ///< mean of prediction minus reading [SI]
  double sigmas = unset;  ///< `bias` divided by its standard error [1]; NaN if the noise is unknown
  /// True if `bias` is significant. If the model is correct, a map contains a significant cell in
  /// at most 5 % of cases (Bonferroni).
  bool significant = false;
};

/// Map of the misfit of a model over two inputs, with the significance of each cell.
///
/// The ranges of an axis come from Comparison::where. A range is a single value if the input has
/// few different values in the record, otherwise a bin. All bins contain about equal numbers of
/// rows. The horizontal axis `across` is the swept input Pattern::along, usually the speed. The
/// vertical axis `up` is the first quantity of this list that varies in the record: a setting such
/// as a load, another input such as a temperature, the run. An axis whose input does not vary has
/// one range with all rows. The map is empty if no input is swept.
///
///   standard error of the mean of m rows = sqrt(Σ s_i²) / m
///
/// s_i is the standard deviation of reading i. This formula assumes that the errors of the rows are
/// independent. If the sensor drifts, the errors are not independent, and `sigmas` is too large.
struct MisfitMap {
  const record::Channel* across_channel = nullptr;
  const record::Channel* up_channel = nullptr;  ///< null if the record has no other input or run
  std::vector<ErrorRange> across;               ///< ranges of the swept input, in ascending order
  std::vector<ErrorRange> up;                   ///< ranges of the other input, in ascending order
  /// Cells that contain rows of the record, sorted by MisfitCell::up, then by MisfitCell::across.
  std::vector<MisfitCell> cells;
  double needed_sigmas = unset;  ///< a cell is significant if |sigmas| exceeds this value
};

/// Returns the map of a comparison with `record`. `std` contains the standard deviation of each
/// reading in `comparison.errors` [SI], NaN if unknown.
[[nodiscard]] MisfitMap misfit_map(const Comparison& comparison, const record::Record& record,
                                   std::span<const double> std);

}  // namespace raceway::verdict
