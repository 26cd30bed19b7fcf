#pragma once

#include <cstddef>
#include <optional>

#include "fit/subject.h"

namespace raceway::verdict {

/// Readings at nearly equal points that differ by more than the scatter of their sensor. The cause
/// is not among the inputs, so no law of these inputs can explain the difference.
struct HiddenInput {
  const record::Channel* channel = nullptr;
  double scatter = unset;         ///< relative standard deviation at equal points [1]
  std::size_t low = 0, high = 0;  ///< rows with the largest difference at one point
  /// Share of the variance that is common to the rows of a run; NaN for fewer than two runs or too
  /// few rows.
  double run_share = unset;
  double run_p_value = unset;  ///< probability of `run_share` by chance; NaN if `run_share` is NaN
  /// Returns true if the readings change mainly from run to run, and less from row to row.
  [[nodiscard]] bool follows_the_runs() const { return run_p_value < 1e-3 && run_share > 0.5; }
};

/// Compares rows whose settings agree within 2 % and whose temperatures agree within 1 K. Few laws
/// change by more than 5 % over such a range. A hidden input is reported if both the pooled and a
/// robust standard deviation exceed Measured::most_scatter. Single wrong readings therefore do not
/// cause a report. An analysis of variance of the logarithms tests whether the differences follow
/// the runs. The result is empty if no hidden input is found. The result is also empty if the test
/// is impossible: with fewer than 8 degrees of freedom, with rows that have a time (run-in makes
/// readings differ at equal points), or with readings that are not positive.
[[nodiscard]] std::optional<HiddenInput> find_hidden_input(const record::Record& record,
                                                           const fit::Measured& measured);

}  // namespace raceway::verdict
