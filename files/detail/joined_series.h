#pragma once

#include <optional>
#include <vector>

#include "files/detail/column_reader.h"
#include "record/record.h"

/// Joins the files of several loggers to one time record.
namespace raceway::files {

/// One file of a time record.
struct SeriesPart {
  record::Record record;
  std::optional<ColumnReader::ClockStart> clock;  ///< empty if the times are numbers
};

/// Joins files by their times. The result has a row for each time that occurs in any file. Cells
/// for which a file has no row are empty. Runs, and settings at the start of a run, last until the
/// next row of their file. The record covers only times at which all files with inputs have rows.
/// Throws InputError if the files have different clocks, if a column occurs twice, or if the files
/// have no time in common.
[[nodiscard]] record::Record joined_series(const std::vector<SeriesPart>& parts);

}  // namespace raceway::files
