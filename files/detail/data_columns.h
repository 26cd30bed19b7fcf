#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "files/detail/column_source.h"
#include "files/detail/signal_channels.h"
#include "model/model_subject.h"
#include "record/note.h"

/// The header of a measurement file; shared with the reader of records.
namespace raceway::files {

/// Columns of a file of times between two speeds, which are converted to torque.
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
  /// Measured channels that are kept, and those that are not. Both are empty for a coast-down.
  std::vector<const record::Channel*> measured, unused;
  std::vector<Place> falls;  ///< times between two speeds; empty if the file has none
  /// Signal of the torque sensor, if its calibration is known. `places` has it as the friction
  /// torque.
  std::optional<Place> signal, signal_deviation;
  std::vector<Recognised::Constant> constants;  ///< values of channels without a column
  std::vector<std::string> others;              ///< unknown headers
  std::vector<record::Note> notes;              ///< on units

  /// Null if the file has no such column.
  [[nodiscard]] const Place* find(const record::Channel& channel) const;
  /// Null if there is none.
  [[nodiscard]] const Recognised::Constant* constant(const record::Channel& channel) const;
  [[nodiscard]] bool coast_down() const { return measured.empty(); }
  /// False for a measured channel that is not kept, and for its deviation.
  [[nodiscard]] bool keeps(const record::Channel& channel) const;
};

/// Throws InputError for a column that looks misspelt and for one that is missing.
[[nodiscard]] DataColumns find_columns(const text::CsvTable& table,
                                       const model::ModelSubject& subject,
                                       const model::Expected& expected, const ReadOptions& options);

}  // namespace raceway::files
