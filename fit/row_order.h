#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "fit/whitening.h"

/// Order of readings in time and in runs.
namespace raceway::fit {

/// Settings that vary and are constant within every run, in words: "axial load"; empty where there
/// are none or no runs. `each_in_one_run`: those alone of which no two runs have the same.
[[nodiscard]] std::string nested_settings(const Record& record, bool each_in_one_run = false);

/// Rows in the one order that all of the diagnosis uses, whatever order a record has: by time where
/// all rows have one (within runs, if runs overlap in time), then by settings. Joined records stay
/// apart. A record without time and runs keeps its order where its rows pass through the swept
/// input at one level of another setting after the other.
[[nodiscard]] std::vector<std::size_t> order_of_rows(const Record& record);

/// Time since the reading before, whether a run begins, and blocks that may be runs, of readings at
/// these rows.
[[nodiscard]] RowOrder row_order(const Record& record, std::span<const std::size_t> rows);

/// The order of some readings, those that are not neighbours anew.
[[nodiscard]] RowOrder order_of(const RowOrder& all, const std::vector<Eigen::Index>& some);

}  // namespace raceway::fit
