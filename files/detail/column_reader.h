#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/detail/column_source.h"
#include "record/note.h"
#include "text/bad_cells.h"
#include "text/timestamp.h"

namespace raceway::files {

/// Reads the cells of a measurement file as numbers, column by column.
class ColumnReader {
 public:
  explicit ColumnReader(const text::CsvTable& table)
      : table_(table), bad(table.source, table.rows()) {}

  /// Returns the numbers of a column [SI]. In rows for which `may_be_empty` is true, a cell that is
  /// empty or has a word such as "OVER" becomes NaN. A note lists the lines with such words.
  /// `with_sign`: true if the values may be negative.
  [[nodiscard]] std::vector<double> numbers(
      const ColumnSource& source, bool with_sign,
      const std::function<bool(std::size_t row)>& may_be_empty);

  /// Returns true if the column contains dates or times of day.
  [[nodiscard]] bool is_stamped(const ColumnSource& source) const;
  /// Returns the times since the first row [s], from a column of dates or of elapsed times. `order`
  /// is the order of day and month in dates with slashes, if the user states it. Throws InputError
  /// if the user does not state the order and the possible orders give different times.
  [[nodiscard]] std::vector<double> times(const ColumnSource& source,
                                          std::optional<text::DateOrder> order);
  /// Kind of the times read by times(), and the time of the first row [s]: since 1970, since
  /// midnight, or since an unknown time.
  enum class ClockKind { dates, elapsed };
  /// A change to or from summer time that times() has removed from the times.
  struct ClockChange {
    double time;  ///< time of the last row before the change, as in the file [s]
    int line;     ///< first row after the change
    bool forward;
  };
  struct ClockStart {
    ClockKind kind;
    double begin;
    bool has_zone = false;  ///< true: the dates have an offset from UTC
    std::vector<ClockChange> changes{};
  };
  [[nodiscard]] const std::optional<ClockStart>& clock_start() const { return clock_start_; }
  /// Returns an index into `names` for each row. The function writes the different texts of the
  /// cells to `names`, in order of first appearance.
  [[nodiscard]] std::vector<double> named(const ColumnSource& source,
                                          std::vector<std::string>& names);

  /// Throws InputError if some cells have a decimal comma and other cells have a decimal point.
  void check_decimal_marks() const;
  /// Returns notes on an unusual file format and on the interpretation of cells, such as dates.
  [[nodiscard]] std::vector<record::Note> notes_on_form() const;

 private:
  struct Mark {
    int line = 0;
    std::string cell;
  };
  [[nodiscard]] bool is_missing(std::size_t row, std::size_t column) const;
  /// Returns the time of a row as one text, from one or two cells.
  [[nodiscard]] std::string stamp(const ColumnSource& source, std::size_t row) const;
  /// Times of a column for one order of its dates.
  struct Reading {
    text::DateOrder order;
    std::vector<double> elapsed;  ///< times since the first row [s]

    /// Returns true if the times jump by most of a year between two rows.
    [[nodiscard]] bool jumps() const;
  };
  [[nodiscard]] text::DateOrder order_of(const ColumnSource& source);
  [[nodiscard]] std::vector<double> elapsed_in(const ColumnSource& source,
                                               text::DateOrder order) const;
  [[noreturn]] void ask_for_order(const ColumnSource& source, const std::vector<Reading>& readings,
                                  std::size_t row) const;
  /// Returns the seconds of the first unit in "12:05": 3600 or 60; nothing if the cells of the
  /// column have another form. Throws InputError if the cells may be hours or minutes.
  [[nodiscard]] std::optional<double> unit_of_short_times(const ColumnSource& source) const;
  void undo_midnights(const ColumnSource& source, std::vector<double>& list);
  [[nodiscard]] std::vector<ClockChange> undo_changes_of_clocks(const ColumnSource& source,
                                                                std::vector<double>& list);
  void keep_mark(char mark, std::size_t row, std::string_view text);

  const text::CsvTable& table_;
  Mark comma_, point_;
  std::optional<ClockStart> clock_start_;
  bool undecided_date_ = false;      ///< true: several date orders give the same times
  std::vector<record::Note> notes_;  // on dates and missing readings

 public:
  text::BadCells bad;  ///< cells with errors so far
};

}  // namespace raceway::files
