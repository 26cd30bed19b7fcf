#pragma once

#include <span>
#include <vector>

#include "verdict/compare.h"

namespace raceway::verdict {

/// Mean residual of the rows in one range of the swept input and one range of another input.
struct MisfitCell {
  std::size_t across = 0, up = 0;  ///< indices in MisfitMap::across and MisfitMap::up
  int rows = 0;
  double bias = unset;    ///< mean of prediction minus reading [SI]
  double sigmas = unset;  ///< `bias` divided by its standard error [1]; NaN if the noise is unknown
  /// True if `bias` is significant at 5 % for the whole map (Bonferroni).
  bool significant = false;
};

/// Map of the misfit of a model over two inputs, with the significance of each cell.
///
/// The ranges come from Comparison::where: single levels if the data have few levels, otherwise
/// bins with about equal numbers of rows. The horizontal axis `across` is the swept input
/// Pattern::along. The vertical axis `up` is another input that varies: a setting such as a load if
/// there is one, otherwise another input such as a temperature, otherwise the run. An axis whose
/// input does not vary has one range with all rows. The map is empty if no input is swept.
///
///   standard error of the mean of m rows = sqrt(Σ s_i²) / m
///
/// s_i is the standard deviation of reading i. This formula assumes independent rows. With drifting
/// noise, cells look more significant than they are.
struct MisfitMap {
  const record::Channel* across_channel = nullptr;
  const record::Channel* up_channel = nullptr;  ///< null if the record has no other input
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
