#pragma once

#include <span>
#include <vector>

#include "verdict/compare.h"

namespace raceway::verdict {

/// Mean error of the rows that fall in one range of the swept input and one range of another.
struct MisfitCell {
  std::size_t across = 0, up = 0;  ///< indices into the axes of the map
  int rows = 0;
  double bias = unset;       ///< mean of prediction minus reading [SI]
  double sigmas = unset;     ///< bias over its standard error; NaN where the noise is not known
  bool significant = false;  ///< beyond chance at 5 % over the whole map (Bonferroni)
};

/// Map of a model's misfit over two inputs, and its significance.
///
/// The ranges come from Comparison::where: levels where the data have few, bins of about equally
/// many rows otherwise. `across` is the input that records sweep (Pattern::along), `up` the first
/// other setting, recorded input or run that varies, loads before temperatures; where none does, an
/// axis has a single range of all rows.
///
///   standard error of the mean of m rows = sqrt(Σ s_i²) / m
///
/// which takes rows as independent: noise that drifts makes cells look more significant than they
/// are.
struct MisfitMap {
  const record::Channel* across_channel = nullptr;
  const record::Channel* up_channel = nullptr;  ///< null where no other input varies
  std::vector<ErrorRange> across;               ///< rising
  std::vector<ErrorRange> up;                   ///< rising
  std::vector<MisfitCell> cells;                ///< cells that have data, row by row of the map
  double needed_sigmas = unset;                 ///< from which a cell is significant
};

/// `std` of each of `comparison.errors` [SI], NaN where not known. The errors point into `record`.
[[nodiscard]] MisfitMap misfit_map(const Comparison& comparison, const record::Record& record,
                                   std::span<const double> std);

}  // namespace raceway::verdict
