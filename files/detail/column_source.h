#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"
#include "text/bad_cells.h"
#include "text/csv.h"

/// Columns of a measurement file with their channels and units; shared by the readers of
/// measurements.
namespace raceway::files {

struct ColumnSource {
  const record::Channel* channel;
  std::size_t column;  ///< index in the file
  std::string name;    ///< name in the header, for messages
  CellUnit cells{};
  bool excel_date = false;             ///< true: the cells are days since 1900 instead of a time
  bool unit_stated = false;            ///< true: a rule of [columns] states the unit
  std::optional<std::size_t> dates{};  ///< column of the date, if `column` is the time of day
};

struct Recognised {
  struct Constant {
    const record::Channel* channel;
    double value;      ///< SI
    std::string from;  ///< "[columns]"
  };
  std::vector<ColumnSource> columns{};  ///< in the order of file_channels()
  std::vector<Constant> constants{};
  std::vector<std::string> others{};          ///< unknown headers
  std::vector<const ColumnRule*> not_here{};  ///< rules for columns that another file may have
  std::vector<record::Note> notes{};          ///< notes on converted units

  [[nodiscard]] const ColumnSource* find(const record::Channel& channel) const;
};

/// Finds the columns. Throws InputError if a column of the map is missing, if two columns give the
/// same quantity, and if a unit contradicts the unit in the header.
[[nodiscard]] Recognised recognise(const text::CsvTable& table, const ReadOptions& options);

/// Returns true if a column has dates or times of day and not numbers.
[[nodiscard]] bool is_stamped(const text::CsvTable& table, const ColumnSource& source);

/// Converts a cell to SI. A cell that is not a number or out of range is added to `bad`.
/// `with_sign`: the input may be negative.
[[nodiscard]] text::ParsedNumber si_of_cell(const text::CsvTable& table, std::size_t row,
                                            const ColumnSource& source, bool with_sign,
                                            text::BadCells& bad);

/// Reads the rows of a file and skips titles. The names of the columns of raceway and of the map
/// identify the header and the row of units.
[[nodiscard]] text::CsvTable read_measurements(const Source& source, const ReadOptions& options);

/// Returns the allowed range of a cell, in the unit of the file. `with_sign` is as in si_of_cell().
[[nodiscard]] text::CellRange range_of(const ColumnSource& source, bool with_sign);

/// Removes these rows and returns a report with their number and positions. `have` describes the
/// problem. The report is empty if no row was removed. Throws InputError if no row remains.
[[nodiscard]] std::string drop_rows(text::CsvTable& table,
                                    const std::function<bool(std::size_t row)>& is_wrong,
                                    std::string_view have);

/// Removes rows in which one of these columns is empty, "nan", "#N/A" or a similar text. Returns a
/// report with their number and positions; empty if no row was removed.
[[nodiscard]] std::string drop_empty_rows(text::CsvTable& table,
                                          const std::vector<ColumnSource>& columns);

}  // namespace raceway::files
