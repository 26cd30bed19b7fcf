#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "fit/whitening.h"

/// Functions that sort rows and readings by time and run.
namespace raceway::fit {

/// Returns a text with the names of the settings that vary between runs but are constant within
/// every run, for example "axial load". The text is empty if there are no such settings or fewer
/// than two runs. If `each_in_one_run` is true, the text names only settings whose value is
/// different in every run.
[[nodiscard]] std::string nested_settings(const Record& record, bool each_in_one_run = false);

/// Returns the row indices in the standard order of a diagnosis. With this order, a diagnosis does
/// not depend on the order of the rows in the record. If all rows have a time, the rows are sorted
/// by time, then by settings and readings. If runs overlap in time, the rows are sorted by run
/// first. Rows without time are sorted by run, then by settings and readings. Rows of different
/// joined records are not mixed.
///
/// Exception: a record without times and without runs keeps its order if it consists of blocks of
/// rows that look like runs (RowOrder::own_levels). Within such a block, the first setting only
/// rises or only falls, and a load is constant. The load differs between the blocks.
[[nodiscard]] std::vector<std::size_t> order_of_rows(const Record& record);

/// Returns the time steps between these rows, the starts of runs and dwells, and the starts of
/// blocks that may be undeclared runs.
[[nodiscard]] RowOrder row_order(const Record& record, std::span<const std::size_t> rows);

/// Returns the RowOrder of a part of the readings. `all` is the RowOrder of all readings, and
/// `some` contains the indices of the part. Readings that are not neighbours among all readings are
/// treated as uncorrelated.
[[nodiscard]] RowOrder order_of(const RowOrder& all, const std::vector<Eigen::Index>& some);

}  // namespace raceway::fit
