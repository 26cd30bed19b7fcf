#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "fit/whitening.h"

/// Functions that sort rows and readings by time and run.
namespace raceway::fit {

/// Returns the names of the settings that vary between runs but are constant within every run:
/// "axial load". The text is empty if there are no such settings or fewer than two runs. With
/// `each_in_one_run`, it names only settings whose value is different in every run.
[[nodiscard]] std::string nested_settings(const Record& record, bool each_in_one_run = false);

/// Returns the row indices in the standard order of a diagnosis, so that the order in the record
/// has no influence. If all rows have a time, they are sorted by time (within runs, if runs overlap
/// in time), then by settings and readings. Otherwise they are sorted by run, then by settings and
/// readings. Joined records remain separate. One exception: a record without time and runs keeps
/// its order if its rows sweep one input at successive levels of another setting.
[[nodiscard]] std::vector<std::size_t> order_of_rows(const Record& record);

/// Returns the time steps between the readings of these rows, the starts of runs, and blocks that
/// may be undeclared runs.
[[nodiscard]] RowOrder row_order(const Record& record, std::span<const std::size_t> rows);

/// Returns the RowOrder of the readings with the indices `some`. Readings that are not neighbours
/// in `all` are treated as not correlated.
[[nodiscard]] RowOrder order_of(const RowOrder& all, const std::vector<Eigen::Index>& some);

}  // namespace raceway::fit
