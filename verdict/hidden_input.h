#pragma once

#include <cstddef>
#include <optional>

#include "fit/subject.h"

namespace raceway::verdict {

/// Evidence for an input that was not recorded: readings at nearly equal inputs differ by more than
/// the scatter of the sensor. No law of the recorded inputs can explain this difference.
struct HiddenInput {
  const record::Channel* channel = nullptr;
  /// Relative standard deviation of readings at nearly equal inputs [1]: the smaller of the pooled
  /// and the robust value.
  double scatter = unset;
  /// Two rows with nearly equal inputs and the largest ratio of readings (`high` over `low`).
  std::size_t low = 0, high = 0;
  /// Share of the variance of these readings that is common to the rows of a run [1]; NaN for fewer
  /// than two runs or too few rows.
  double run_share = unset;
  /// Probability of a `run_share` at least this large by chance; NaN if `run_share` is NaN.
  double run_p_value = unset;
  /// Returns true if the readings change mainly from run to run, and less from row to row.
  [[nodiscard]] bool follows_the_runs() const { return run_p_value < 1e-3 && run_share > 0.5; }
};

/// Compares readings of rows whose speeds and loads agree within 2 % and whose temperatures agree
/// within 1 K. Few laws change by more than 5 % over such a range. A hidden input is reported if
/// both the pooled and a robust relative standard deviation of these readings exceed
/// Measured::most_scatter. Single wrong readings therefore do not cause a report. An analysis of
/// variance of the logarithms of the readings tests whether the differences follow the runs. The
/// result is empty if no hidden input is found. The result is also empty if Measured::most_scatter
/// is unknown, if there are fewer than 8 degrees of freedom, if a reading is not positive, or if
/// rows have a time (run-in makes readings at equal inputs differ).
[[nodiscard]] std::optional<HiddenInput> find_hidden_input(const record::Record& record,
                                                           const fit::Measured& measured);

}  // namespace raceway::verdict
