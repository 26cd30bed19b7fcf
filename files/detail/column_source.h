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

/// Column of a measurement file with its channel and unit.
namespace raceway::files {

struct ColumnSource {
  const record::Channel* channel;
  std::size_t column;  ///< index of the column in the file
  std::string name;    ///< name in the header, for messages
  CellUnit cells{};
  bool excel_date = false;             ///< true: the cells are days since 1900, as in Excel
  bool unit_stated = false;            ///< true: a rule of [columns] states the unit
  std::optional<std::size_t> dates{};  ///< column of the date, if `column` is the time of day
};

struct Recognised {
  struct Constant {
    const record::Channel* channel;
    double value;      ///< value for all rows [SI]
    std::string from;  ///< origin of the value for messages: "[columns]"
  };
  std::vector<ColumnSource> columns{};  ///< columns in the order of file_channels()
  std::vector<Constant> constants{};
  std::vector<std::string> others{};          ///< headers of unknown columns
  std::vector<const ColumnRule*> not_here{};  ///< rules for columns that another file may have
  std::vector<record::Note> notes{};          ///< notes on converted units

  [[nodiscard]] const ColumnSource* find(const record::Channel& channel) const;
};

/// Finds the columns of a file. Throws InputError if two columns give the same quantity, and if a
/// rule of `options.columns` names a column that is missing. Of several headers for one quantity,
/// the file needs one. A column may be missing if the record has several files
/// (ReadOptions::of_several), and a measured column with ReadOptions::without_readings.
[[nodiscard]] Recognised recognise(const text::CsvTable& table, const ReadOptions& options);

/// Returns true if a record may lack the column of this rule (ReadOptions::without_readings).
[[nodiscard]] bool may_be_missing(const ColumnRule& rule, const ReadOptions& options);

/// Returns true if a column contains dates or times of day, not numbers.
[[nodiscard]] bool is_stamped(const text::CsvTable& table, const ColumnSource& source);

/// Converts the number in a cell to SI. A cell that is not a number, or is outside the allowed
/// range, is added to `bad`. `with_sign`: true if the value may be negative.
[[nodiscard]] text::ParsedNumber si_of_cell(const text::CsvTable& table, std::size_t row,
                                            const ColumnSource& source, bool with_sign,
                                            text::BadCells& bad);

/// Reads the rows of a file and skips title lines. The function recognises the header and the row
/// of units by the column names of raceway and of `options.columns`.
[[nodiscard]] text::CsvTable read_measurements(const Source& source, const ReadOptions& options);

/// Returns the allowed range of a cell, in the unit of the file. `with_sign`: as in si_of_cell().
[[nodiscard]] text::CellRange range_of(const ColumnSource& source, bool with_sign);

/// Removes the rows for which `is_wrong` is true, and returns a note with their number and
/// positions. `have` describes the fault of these rows. The note is empty if no row was removed.
/// Throws InputError if no row remains.
[[nodiscard]] std::string drop_rows(text::CsvTable& table,
                                    const std::function<bool(std::size_t row)>& is_wrong,
                                    std::string_view have);

/// Removes rows in which one of these columns has an empty cell, "nan", "#N/A" or a similar text.
/// Returns a note with their number and positions; empty if no row was removed.
[[nodiscard]] std::string drop_empty_rows(text::CsvTable& table,
                                          const std::vector<ColumnSource>& columns);

/// Returns the advice for a file whose columns have other names than the columns of raceway.
[[nodiscard]] std::string if_named_otherwise(const text::CsvTable& table);

}  // namespace raceway::files
