#pragma once

#include <cstddef>
#include <optional>

#include "fit/subject.h"

namespace raceway::verdict {

/// Readings that differ at nearly equal points by more than a sensor of their kind scatters: what
/// makes the difference is in none of the inputs, so that no law of them explains it.
struct HiddenInput {
  const record::Channel* channel = nullptr;
  double scatter = unset;         ///< relative standard deviation at equal points [1]
  std::size_t low = 0, high = 0;  ///< rows that differ most within one point
  double run_share = unset;       ///< of that variance, common to the rows of a run; NaN without
  double run_p_value = unset;     ///< of the runs having nothing to do with it; NaN without runs
  /// A run has its own level: no scatter from row to row.
  [[nodiscard]] bool follows_the_runs() const { return run_p_value < 1e-3 && run_share > 0.5; }
};

/// Compares rows whose settings agree within 2 %, temperatures within 1 K: few laws change by more
/// than 5 % over that. Found is what scatters by more than Measured::most_scatter by the pooled
/// standard deviation and by a robust one as well, so that single wrong readings do not count.
/// True if it goes with the runs is asked by an analysis of variance of the logarithms.
/// Nothing where it cannot be asked: fewer than 8 degrees of freedom, rows with a time (what runs
/// in reads differently at equal points), or a reading that is not positive.
[[nodiscard]] std::optional<HiddenInput> find_hidden_input(const record::Record& record,
                                                           const fit::Measured& measured);

}  // namespace raceway::verdict
