#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "record/channel.h"
#include "record/note.h"

namespace raceway::record {

/// Values of one channel, one for each row of a record.
struct Column {
  const Channel* channel = nullptr;
  std::vector<double> values;  ///< [SI]; NaN without a reading
  /// True if the deviation comes from a regression over many more samples than rows. The deviation
  /// then counts as known.
  bool known = false;
};

/// One of several joined records.
struct Part {
  std::string name;    ///< "monday" for data/monday.csv
  std::string source;  ///< file name, for messages
};

/// Rows between which a setting of a time record is valid. Settings are all inputs that are
/// constant between rows, such as speeds, loads and the coolant state.
enum class SettingsHold {
  sampled,   ///< valid from its row to the next; the reading in the row was taken with this setting
  from_row,  ///< valid from its row to the next; the reading in the row was taken just before the
             ///< change
  until_row,  ///< valid from the previous row to the row of the setting
};

/// Measured data: columns over rows. Rows are identified by their index; line numbers of the file
/// are only for messages.
struct Record {
  std::string source{};             ///< file name, for messages
  std::vector<Column> columns{};    ///< columns of equal length
  std::vector<std::string> runs{};  ///< names of the runs; the column `run` contains their indices
  std::vector<int> lines{};         ///< line of each row in the file; empty if there is no file
  std::vector<Note> notes{};        ///< notes of the file reader for the user
  /// True if all readings share one unknown factor.
  bool up_to_a_factor = false;
  SettingsHold settings_hold = SettingsHold::sampled;  ///< only for a time record
  /// Parts of a record from joined(), with indices in the column `part`; otherwise empty.
  std::vector<Part> parts{};

  [[nodiscard]] std::size_t rows() const {
    return columns.empty() ? 0 : columns.front().values.size();
  }
  /// Returns the column of a channel; null if there is none.
  [[nodiscard]] const Column* find(const Channel& channel) const;
  [[nodiscard]] Column* find(const Channel& channel);
  [[nodiscard]] bool has(const Channel& channel) const { return find(channel) != nullptr; }
  /// Returns the values by row [SI]; empty without such a column.
  [[nodiscard]] std::span<const double> values(const Channel& channel) const;
  /// Returns the value of a row [SI]; NaN without such a column or without a reading.
  [[nodiscard]] double value(const Channel& channel, std::size_t row) const;
  /// Returns the index of the run of a row; -1 without runs.
  [[nodiscard]] int run_of(std::size_t row) const;
  /// Returns the index of the part of a row; 0 if the record was not joined.
  [[nodiscard]] std::size_t part_of(std::size_t row) const;

  /// Adds a column or replaces the column of the same channel. Throws std::invalid_argument if the
  /// number of values differs from the number of rows.
  Column& set(const Channel& channel, std::vector<double> values);

  /// Returns true if the values of a channel differ by more than its step, absolute or relative to
  /// the largest value.
  [[nodiscard]] bool varies(const Channel& channel) const;
  /// Returns the deviation of a measured channel; null if the record has none.
  [[nodiscard]] const Column* deviation_of(const Channel& measured) const;
  /// Returns true if every row has a value of that channel.
  [[nodiscard]] bool complete(const Channel& channel) const;

  /// Returns a record with these rows, in this order.
  [[nodiscard]] Record picked(std::span<const std::size_t> rows) const;
  /// Returns a record with the same columns, but without rows.
  [[nodiscard]] Record without_rows() const;

  /// Returns the place of a row in words: "line 12" for a file, otherwise "row 3" (counted from 1).
  /// For joined records, the name of the part follows: "line 12 of monday".
  [[nodiscard]] std::string place(std::size_t row) const;
  /// Returns the line of a row in the file, or the number of the row (counted from 1) if there is
  /// no file.
  [[nodiscard]] int line(std::size_t row) const;
};

/// Joins records of one kind. The result has all rows, record by record, and separate runs for each
/// record. The records are sorted by their file names, so the order in the argument has no
/// influence. The result has all columns of any record, with NaN if a record lacks a column. A part
/// has the name of its source without folder and extension. If two of these names are equal, both
/// include the folder. A deviation counts as known only if it is known in all records. The result
/// keeps the notes of all records. Throws std::invalid_argument for fewer than two records, for two
/// records of one source, for a record whose readings have an unknown factor, and for records with
/// different `settings_hold`.
[[nodiscard]] Record joined(std::vector<Record> records);

}  // namespace raceway::record
