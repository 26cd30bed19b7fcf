#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "fit/whitening.h"

/// Orders readings in time and in runs.
namespace raceway::fit {

/// Returns the settings that vary between runs and are constant within every run, as text: "axial
/// load". The text is empty if there are no such settings or no runs. With `each_in_one_run`, the
/// text names only settings that differ between any two runs.
[[nodiscard]] std::string nested_settings(const Record& record, bool each_in_one_run = false);

/// Returns the rows in the standard order of a diagnosis, independent of their order in the record:
/// by time if all rows have a time (within runs, if runs overlap in time), then by settings and
/// readings. Without a time, rows are sorted by run first. Joined records remain separate. A record
/// without time and runs keeps its order if its rows sweep one input at successive levels of
/// another setting.
[[nodiscard]] std::vector<std::size_t> order_of_rows(const Record& record);

/// Returns, for readings at these rows, the time since the previous reading, the starts of runs,
/// and blocks that may be runs.
[[nodiscard]] RowOrder row_order(const Record& record, std::span<const std::size_t> rows);

/// Returns the RowOrder of selected readings. Readings that are not neighbours in the original
/// order have no correlation.
[[nodiscard]] RowOrder order_of(const RowOrder& all, const std::vector<Eigen::Index>& some);

}  // namespace raceway::fit
