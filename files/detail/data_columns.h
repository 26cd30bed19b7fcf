#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "files/detail/column_source.h"
#include "files/detail/signal_channels.h"
#include "model/model_subject.h"
#include "record/note.h"

/// Header of a measurement file; shared with the reader of records.
namespace raceway::files {

/// Columns of a file with times between two speeds. These times are converted to torque.
inline constexpr record::Channel speed_from{.name = "speed_from_rpm",
                                            .variable = "speed_from",
                                            .words = "speed from",
                                            .unit = "rpm",
                                            .factor = rpm,
                                            .lower = 1e-3,
                                            .upper = 1e6};
inline constexpr record::Channel speed_to{.name = "speed_to_rpm",
                                          .variable = "speed_to",
                                          .words = "speed to",
                                          .unit = "rpm",
                                          .factor = rpm,
                                          .lower = 1e-3,
                                          .upper = 1e6};
inline constexpr record::Channel fall_time{
    .name = "time_s", .unit = "s", .lower = 1e-6, .upper = 1e9};
inline constexpr record::Channel fall_time_deviation{
    .name = "std_time_s", .unit = "s", .lower = 1e-9, .upper = 1e9};

/// Columns of a file with their channels.
struct DataColumns {
  using Place = ColumnSource;
  std::vector<Place> places;  ///< in the order of the table of channels
  /// Measured channels that are kept, and measured channels that are not kept. Both are empty for a
  /// coast-down.
  std::vector<const record::Channel*> measured, unused;
  std::vector<Place> falls;  ///< times between two speeds; empty if the file has none
  /// Signal of the torque sensor, if its calibration is known. `places` contains the signal as the
  /// friction torque.
  std::optional<Place> signal, signal_deviation;
  std::vector<Recognised::Constant> constants;  ///< values of channels without a column
  std::vector<std::string> others;              ///< unknown headers
  std::vector<record::Note> notes;              ///< notes on units

  /// Returns null if the file has no column of this channel.
  [[nodiscard]] const Place* find(const record::Channel& channel) const;
  /// Returns null if there is no constant for this channel.
  [[nodiscard]] const Recognised::Constant* constant(const record::Channel& channel) const;
  [[nodiscard]] bool coast_down() const { return measured.empty(); }
  /// Returns false for a measured channel that is not kept, and for its standard deviation.
  [[nodiscard]] bool keeps(const record::Channel& channel) const;
};

/// Finds the columns. Throws InputError if a column name looks misspelt or if a column is missing.
[[nodiscard]] DataColumns find_columns(const text::CsvTable& table,
                                       const model::ModelSubject& subject,
                                       const model::Expected& expected, const ReadOptions& options);

}  // namespace raceway::files
