#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "files/detail/column_source.h"
#include "files/detail/signal_channels.h"
#include "model/model_subject.h"
#include "record/note.h"

/// Columns of a measurement file, for read_record().
namespace raceway::files {

/// Columns of a coast-down file that gives the time between two speeds. The reader converts these
/// times to friction torque.
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

/// Recognised columns of a measurement file.
struct DataColumns {
  using Place = ColumnSource;
  std::vector<Place> places;  ///< columns in the order of file_channels()
  /// Measured channels that the record keeps (`measured`) and that it omits (`unused`). Both lists
  /// are empty for a coast-down.
  std::vector<const record::Channel*> measured, unused;
  std::vector<Place> falls;  ///< columns with times between two speeds, if any
  /// Signal of the torque sensor and its standard deviation, if the calibration is known. The
  /// column of the signal is also in `places`, with the channel of the friction torque.
  std::optional<Place> signal, signal_deviation;
  std::vector<Recognised::Constant> constants;  ///< values of channels without a column
  std::vector<std::string> others;              ///< headers of unknown columns
  std::vector<record::Note> notes;              ///< notes on units

  /// Returns the column of this channel; null if the file has none.
  [[nodiscard]] const Place* find(const record::Channel& channel) const;
  /// Returns the constant value for this channel; null if there is none.
  [[nodiscard]] const Recognised::Constant* constant(const record::Channel& channel) const;
  [[nodiscard]] bool coast_down() const { return measured.empty(); }
  /// Returns false for a measured channel that is not kept, and for its standard deviation.
  [[nodiscard]] bool keeps(const record::Channel& channel) const;
};

/// Finds the columns of a file. Throws InputError if a column name looks misspelt or if a required
/// column is missing.
[[nodiscard]] DataColumns find_columns(const text::CsvTable& table,
                                       const model::ModelSubject& subject,
                                       const model::Expected& expected, const ReadOptions& options);

}  // namespace raceway::files
