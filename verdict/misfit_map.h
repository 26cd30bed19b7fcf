#pragma once

#include <span>
#include <vector>

#include "verdict/compare.h"

namespace raceway::verdict {

/// Mean error of the rows within one range of the swept input and one range of another input.
struct MisfitCell {
  std::size_t across = 0, up = 0;  ///< indices into the axes of the map
  int rows = 0;
  double bias = unset;       ///< mean of prediction minus reading [SI]
  double sigmas = unset;     ///< bias over its standard error; NaN if the noise is unknown
  bool significant = false;  ///< true if significant at 5 % over the whole map (Bonferroni)
};

/// Map of the misfit of a model over two inputs, with the significance of each cell.
///
/// The ranges come from Comparison::where: single levels if the data have few levels, otherwise
/// bins with about equal numbers of rows. `across` is the swept input, Pattern::along. `up` is the
/// first other input that varies. Settings with a ratio scale, such as loads, come first. All other
/// inputs follow, such as temperatures, and then runs. An axis without a varying input has one
/// range with all rows.
///
///   standard error of the mean of m rows = sqrt(Σ s_i²) / m
///
/// This formula assumes independent rows. With drifting noise, cells look more significant than
/// they are.
struct MisfitMap {
  const record::Channel* across_channel = nullptr;
  const record::Channel* up_channel = nullptr;  ///< null if no other input varies
  std::vector<ErrorRange> across;               ///< ranges of the swept input, rising
  std::vector<ErrorRange> up;                   ///< ranges of the other input, rising
  std::vector<MisfitCell> cells;                ///< cells with data, row by row of the map
  double needed_sigmas = unset;  ///< a cell is significant if |sigmas| exceeds this value
};

/// `std` contains the standard deviation of each of `comparison.errors` [SI], NaN if unknown. The
/// errors must refer to `record`.
[[nodiscard]] MisfitMap misfit_map(const Comparison& comparison, const record::Record& record,
                                   std::span<const double> std);

}  // namespace raceway::verdict
