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
  std::vector<double> values;  ///< value in each row [SI]; NaN if the row has no value
  /// True if the column contains standard deviations that are treated as exact, because each one
  /// comes from a regression over many samples.
  bool known = false;
};

/// One of the records from which joined() made a record.
struct Part {
  std::string name;    ///< name of the record in messages, such as "monday" for data/monday.csv
  std::string source;  ///< file name, for messages
};

/// Time interval in which a setting in a row of a time record is valid. Settings are all inputs
/// that are constant between rows, such as speeds, loads and coolant on or off.
enum class SettingsHold {
  /// The setting in a row is valid from this row to the next row. The reading in this row was taken
  /// with this setting.
  sampled,
  /// The setting in a row is valid from this row to the next row. The reading in this row was taken
  /// just before the setting changed.
  from_row,
  until_row,  ///< the setting in a row is valid from the previous row to this row
};

/// Measured data, with a column for each quantity and a row for each time or operating point.
/// Functions identify a row by its index. The line number in the file is only for messages.
struct Record {
  std::string source{};           ///< file name, for messages
  std::vector<Column> columns{};  ///< columns of equal length
  /// Names of the runs. A run is an uninterrupted part of the record. The column of the channel
  /// `run` contains indices into this list.
  std::vector<std::string> runs{};
  std::vector<int> lines{};   ///< line of each row in the file; empty if there is no file
  std::vector<Note> notes{};  ///< notes of the file reader for the user
  /// True if the readings have an unknown common factor, such as the torques of a coast-down with
  /// unknown inertia.
  bool up_to_a_factor = false;
  /// Time interval in which the settings of a row are valid; used only in time records.
  SettingsHold settings_hold = SettingsHold::sampled;
  /// Original records if joined() made this record, otherwise empty. The column of the channel
  /// `part` contains indices into this list.
  std::vector<Part> parts{};

  [[nodiscard]] std::size_t rows() const {
    return columns.empty() ? 0 : columns.front().values.size();
  }
  /// Returns the column of a channel; null if there is none.
  [[nodiscard]] const Column* find(const Channel& channel) const;
  [[nodiscard]] Column* find(const Channel& channel);
  [[nodiscard]] bool has(const Channel& channel) const { return find(channel) != nullptr; }
  /// Returns the value of the channel in each row [SI]; empty if the record has no such column.
  [[nodiscard]] std::span<const double> values(const Channel& channel) const;
  /// Returns the value of the channel in one row [SI]; NaN if the record has no such column or the
  /// row has no value.
  [[nodiscard]] double value(const Channel& channel, std::size_t row) const;
  /// Returns the index of the run of a row; -1 if the row belongs to no run.
  [[nodiscard]] int run_of(std::size_t row) const;
  /// Returns the index (in `parts`) of the record that a row comes from; 0 if the record was not
  /// joined.
  [[nodiscard]] std::size_t part_of(std::size_t row) const;

  /// Adds a column or replaces the column of the same channel. Throws std::invalid_argument if the
  /// number of values differs from the number of rows.
  Column& set(const Channel& channel, std::vector<double> values);

  /// Returns true if the values differ by more than step_of(), the largest difference of values
  /// that are treated as equal.
  [[nodiscard]] bool varies(const Channel& channel) const;
  /// Returns the column with the standard deviations of a measured channel; null if the record has
  /// none.
  [[nodiscard]] const Column* deviation_of(const Channel& measured) const;
  /// Returns true if every row has a finite value of this channel.
  [[nodiscard]] bool complete(const Channel& channel) const;

  /// Returns a record with the rows that have the indices `rows`, in the order of `rows`.
  [[nodiscard]] Record picked(std::span<const std::size_t> rows) const;
  /// Returns a record with the same columns, but without rows.
  [[nodiscard]] Record without_rows() const;

  /// Returns the place of a row in words: "line 12" for a file, otherwise "row 3" (counted from 1).
  /// For joined records, the name of the original record follows: "line 12 of monday".
  [[nodiscard]] std::string place(std::size_t row) const;
  /// Returns the line number of a row in the file. If there is no file, returns the number of the
  /// row, counted from 1.
  [[nodiscard]] int line(std::size_t row) const;
};

/// Joins several records into one record. The result contains the rows of all records, one record
/// after the other; the records are sorted by `source`. Runs of different records stay separate.
/// The result has every column that occurs in any record; a row has NaN if its record has no such
/// column. Column::known is true only if all records have this column with `known` = true.
/// Part::name is the file name without folder and extension. If two of these names are equal, both
/// names include the folder. The result contains the notes of all records.
///
/// Throws std::invalid_argument for fewer than two records, for two records with the same `source`,
/// for a record whose `up_to_a_factor` is true, and for records with different `settings_hold`.
[[nodiscard]] Record joined(std::vector<Record> records);

}  // namespace raceway::record
