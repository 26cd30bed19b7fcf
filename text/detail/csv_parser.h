#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/csv.h"
#include "text/detail/csv_cells.h"
#include "text/labview_head.h"

namespace raceway::text {

/// Reads a delimited text line by line: it stores header, units and notes in a table, and passes
/// rows to a function.
class CsvParser {
 public:
  using TakeRow = std::function<void(std::span<const CellSpan> cells, int line)>;

  /// Origin of a table. Tables of this program have the units in the column names. Other files may
  /// have a column of units after each column of values.
  enum class Origin { this_program, others };

  /// The parser changes `text` in place and may append to it.
  CsvParser(CsvTable& table, std::string& text, const CsvForm& form, Origin origin,
            TakeRow take_row)
      : table_(table),
        text_(text),
        end_(text.size()),
        form_(form),
        origin_(origin),
        give_row_(std::move(take_row)) {}

  /// Parses the text. Throws InputError in the cases of read_csv().
  void run();
  /// Adds notes on lines skipped above, between and below the rows.
  void add_notes();

 private:
  struct Line {
    int number = 0;
    std::size_t begin = 0, end = 0;  ///< limits of the line, without the line ending
  };
  struct Row {
    std::vector<CellSpan> cells;
    int line;
  };

  bool next(Line& line);
  void take(const Line& line);
  [[nodiscard]] bool is_comment(const Line& line) const;
  void take_comment(const Line& line);
  bool take_header(const Line& line);
  void read_header(const Line& line);
  void check_names(int line);
  void find_unit_columns(std::vector<CellSpan>& names, const Line& header);
  void take_units(std::vector<CellSpan>& cells, int line);
  void take_row(const Line& line);
  void fit_to_header(std::vector<CellSpan>& cells);
  [[nodiscard]] bool is_header(const std::vector<CellSpan>& cells) const;
  [[nodiscard]] bool is_unit_row_again(int line) const;
  [[nodiscard]] bool is_footer(const std::vector<CellSpan>& cells) const;
  [[nodiscard]] bool may_be_statistics(const std::vector<CellSpan>& cells) const;
  void give(const std::vector<CellSpan>& cells, int line);
  void give_held();
  [[noreturn]] void refuse(const std::vector<CellSpan>& cells, const Line& line) const;

  [[nodiscard]] std::string_view text_of(const CellSpan& c) const {
    return std::string_view(text_).substr(c.begin, c.size);
  }
  [[nodiscard]] std::string_view content(const Line& line) const {
    return std::string_view(text_).substr(line.begin, line.end - line.begin);
  }
  [[nodiscard]] Place place(int line) const { return {.file = table_.source, .line = line}; }

  CsvTable& table_;
  std::string& text_;
  const std::size_t end_;  ///< end of the original text
  const CsvForm form_;
  const Origin origin_;
  TakeRow give_row_;

  std::size_t at_ = 0;         ///< start of the next line
  int line_ = 0;               ///< number of the last line
  Line comment_;               ///< the last comment, without leading blanks
  std::vector<bool> is_unit_;  ///< for each column: true if it contains units of the column before
  std::vector<Row> held_;      ///< rows that may be a footer; a footer if no other row follows
  LabviewHead labview_;
  std::size_t empty_ends_ = 0;  ///< separators after the last name
  std::size_t titles_ = 0, empty_rows_ = 0, headers_again_ = 0, rows_ = 0;
  int footer_ = 0;  ///< line of the first footer row
  std::size_t footers_ = 0, lines_between_ = 0;
  bool behind_header_ = false;        ///< true: the line before was a repeated header
  std::vector<CellSpan> cells_;       ///< cells of the current line
  bool begins_with_reading_ = false;  ///< true: the first row begins with a reading
};

}  // namespace raceway::text
