#pragma once

#include <cstddef>
#include <optional>

#include "fit/subject.h"

namespace raceway::verdict {

/// Evidence for an input that was not recorded: readings at nearly equal inputs differ by more than
/// the scatter of the sensor. No law that uses only the recorded inputs can explain this
/// difference.
struct HiddenInput {
  const record::Channel* channel = nullptr;
  /// Relative standard deviation of readings at nearly equal inputs [1]: the smaller of a pooled
  /// and a robust estimate.
  double scatter = unset;
  /// Indices of the two rows that have the largest ratio of readings (`high` over `low`) among rows
  /// with nearly equal inputs.
  std::size_t low = 0, high = 0;
  /// Share of the variance of readings at nearly equal inputs that comes from differences between
  /// runs [1]; NaN for fewer than two runs or too few rows.
  double run_share = unset;
  /// Probability that chance alone gives this `run_share` or a larger one; NaN if `run_share` is
  /// NaN.
  double run_p_value = unset;
  /// Returns true if the readings differ mainly between runs, and less between the rows of a run.
  [[nodiscard]] bool follows_the_runs() const { return run_p_value < 1e-3 && run_share > 0.5; }
};

/// Compares readings of rows whose speeds and loads agree within 2 % and whose temperatures agree
/// within 1 K. Such differences change the friction by more than 5 % in few friction laws. The
/// function reports a hidden input if two estimates of the relative standard deviation of these
/// readings, pooled and robust, both exceed Measured::most_scatter. A few wrong readings are
/// therefore not reported as a hidden input. An analysis of variance of the logarithms of the
/// readings tests whether the readings differ between runs.
///
/// The result is empty if no hidden input is found, or if the test is impossible:
/// Measured::most_scatter is unknown, there are fewer than 8 degrees of freedom, or a reading is
/// not positive. The result is also empty if rows have a time, because run-in may then change the
/// readings at equal inputs.
[[nodiscard]] std::optional<HiddenInput> find_hidden_input(const record::Record& record,
                                                           const fit::Measured& measured);

}  // namespace raceway::verdict
