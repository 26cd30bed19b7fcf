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
  std::vector<double> values;  ///< SI; NaN where nothing was read
  /// True for a deviation from a regression over many more samples than rows: it counts as known.
  bool known = false;
};

/// One of several records that were joined to one.
struct Part {
  std::string name;    ///< "monday" of data/monday.csv
  std::string source;  ///< file name, for messages
};

/// Rows between which a setting of a record over time holds: a speed, a load, the coolant.
enum class SettingsHold {
  sampled,    ///< from its row until the next; a reading in its row was taken with it
  from_row,   ///< from its row until the next; a reading in its row was taken just before it
  until_row,  ///< from the row before until its own
};

/// Measured data: columns over rows. Rows are identified by their index; lines of the file are kept
/// for messages only.
struct Record {
  std::string source{};             ///< file name, for messages
  std::vector<Column> columns{};    ///< all of one length
  std::vector<std::string> runs{};  ///< names of the runs, to which the column `run` has indices
  std::vector<int> lines{};         ///< of the file, by row; empty where rows come from no file
  std::vector<Note> notes{};        ///< actions of the reader, for the user
  /// True if the readings share one unknown factor.
  bool up_to_a_factor = false;
  SettingsHold settings_hold = SettingsHold::sampled;  ///< of a record over time
  /// Parts of a record made by joined(), indexed by the column `part`; otherwise empty.
  std::vector<Part> parts{};

  [[nodiscard]] std::size_t rows() const {
    return columns.empty() ? 0 : columns.front().values.size();
  }
  /// The column of a channel, null where there is none.
  [[nodiscard]] const Column* find(const Channel& channel) const;
  [[nodiscard]] Column* find(const Channel& channel);
  [[nodiscard]] bool has(const Channel& channel) const { return find(channel) != nullptr; }
  /// [SI] by row; empty where there is no such column.
  [[nodiscard]] std::span<const double> values(const Channel& channel) const;
  /// [SI]; NaN where there is no such column or nothing was read.
  [[nodiscard]] double value(const Channel& channel, std::size_t row) const;
  /// Index of the run of a row, -1 without.
  [[nodiscard]] int run_of(std::size_t row) const;
  /// Index of the part of a row; 0 where nothing was joined.
  [[nodiscard]] std::size_t part_of(std::size_t row) const;

  /// Adds a column, or replaces the column of its channel. Throws std::invalid_argument where its
  /// length differs from the others.
  Column& set(const Channel& channel, std::vector<double> values);

  /// True if rows differ on a channel by more than its step, absolute or as a share of the largest.
  [[nodiscard]] bool varies(const Channel& channel) const;
  /// The deviation of a measured channel that the record has, null where it has none.
  [[nodiscard]] const Column* deviation_of(const Channel& measured) const;
  /// True where every one of these rows has a number on that channel.
  [[nodiscard]] bool complete(const Channel& channel) const;

  /// These rows, in this order.
  [[nodiscard]] Record picked(std::span<const std::size_t> rows) const;
  /// Columns without any row.
  [[nodiscard]] Record without_rows() const;

  /// "line 12" of a file, otherwise "row 3", counted from 1; "line 12 of monday" of a part.
  [[nodiscard]] std::string place(std::size_t row) const;
  /// The line of a row, or its number counted from 1.
  [[nodiscard]] int line(std::size_t row) const;
};

/// Records of one kind as one, in the order of their sources, whatever the order they come in: rows
/// one record after the other, all columns that any of them has (NaN where one has none), the runs
/// of each for themselves. A part is named by its source without folder and ending; where two would
/// be alike, with the folder. A deviation is as good as known where it is so in all. Notes of all
/// are kept. Throws std::invalid_argument: less than two records, two of one source, one of which
/// the readings are known up to a factor alone.
[[nodiscard]] Record joined(std::vector<Record> records);

}  // namespace raceway::record
