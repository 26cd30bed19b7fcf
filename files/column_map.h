#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "record/channel.h"
#include "record/record.h"
#include "rig/torque_sensor.h"
#include "text/error.h"
#include "text/timestamp.h"
#include "text/units.h"

namespace raceway::files {

/// Conversion of a number in a measurement file to SI.
struct CellUnit {
  const text::Unit* unit = nullptr;  ///< unit of the number; null: the unit of the channel
  double factor = 1.0;               ///< factor on the number in the file; -1 changes the sign

  [[nodiscard]] double to_SI(const record::Channel& channel, double cell) const {
    return unit ? unit->to_SI(cell * factor) : channel.to_SI(cell * factor);
  }
  [[nodiscard]] double in_cell(const record::Channel& channel, double si) const {
    return (unit ? unit->in_unit(si) : channel.in_unit(si)) / factor;
  }
};

/// A quantity (channel) and its unit, identified by a column name in a file.
struct NamedChannel {
  const record::Channel* channel;
  const text::Unit* unit =
      nullptr;  ///< null: the unit is the unit of the channel, or the channel has no unit
};

/// Returns the unit of a channel from the table of units; null for a channel without a unit (a run,
/// a count).
[[nodiscard]] const text::Unit* unit_of(const record::Channel& channel);

/// Returns the quantity with this name from `channels`; nothing if there is none. The unit in the
/// name may be another unit of the same dimension: "friction_torque_Nm", "speed [1/min]".
[[nodiscard]] std::optional<NamedChannel> named_channel(
    std::string_view name, std::span<const record::Channel* const> channels);

/// Works like named_channel(), for all quantities of time records: "front_bearing_temperature_K",
/// "displacement_z [mm]".
[[nodiscard]] std::optional<NamedChannel> named_series_channel(std::string_view name);

/// Works like named_channel(), for all quantities of a spindle record. Temperatures of the
/// surroundings are inputs, and all other temperatures are measured quantities.
[[nodiscard]] std::optional<NamedChannel> named_spindle_channel(std::string_view name);

/// One line of the table [columns] in a model file: the source of one quantity in a measurement
/// file.
struct ColumnRule {
  std::string key;                   ///< as written in [columns]: "friction_torque_Nmm"
  const record::Channel* channel;    ///< quantity that the key names
  const text::Unit* key_unit;        ///< unit at the end of the key; null: the unit of the channel
  std::string header{};              ///< header of the user's column; empty for a constant
  std::optional<double> constant{};  ///< value for all rows, in the unit of the key
  const text::Unit* unit = nullptr;  ///< unit of the user's column, if the rule states it
  bool excel_date = false;           ///< true: the times are days since 1900, as in Excel
  double factor = 1.0;               ///< factor that multiplies the numbers
  text::Place place{};               ///< file and line of the rule
};

/// One line of the table [transducers]: a displacement as a weighted sum of transducer readings.
struct Combination {
  struct Term {
    const record::Channel* transducer;
    double factor;  ///< factor of the reading [m/m]; for an angle [rad/m]
  };
  const record::Channel* displacement;
  std::vector<Term> terms{};
  text::Place place{};
};

/// The tables [columns] and [transducers] of a model file or of a separate file.
struct ColumnMap {
  std::string source{};
  std::vector<ColumnRule> rules{};
  char decimal_mark = '\0';                     ///< decimal mark of the file; '\0': not given
  std::optional<text::DateOrder> date_order{};  ///< order of day and month in dates with slashes
  /// Time interval in which the settings of a row, such as the speed, are valid. Only for a time
  /// record. Default: SettingsHold::until_row for a spindle, otherwise SettingsHold::sampled.
  std::optional<record::SettingsHold> settings_hold{};
  std::vector<Combination> transducers{};  ///< only for a time record

  [[nodiscard]] const ColumnRule* find(std::string_view header) const;
  /// Returns the transducer in [transducers] with this name and any unit of length, such as "x1_um"
  /// or "x1 [nm]"; nothing if there is none.
  [[nodiscard]] std::optional<NamedChannel> find_transducer(std::string_view name) const;
};

/// Options for reading a file of measurements.
struct ReadOptions {
  ColumnMap columns{};
  /// Calibration that converts a column torque_signal_V to friction torque.
  std::optional<rig::TorqueSensor> sensor{};
  bool drop_nan = false;    ///< true: rows with a missing number are omitted, with a note
  bool over_time = false;   ///< true: the file is a time record
  bool of_spindle = false;  ///< true: the file is a time record of a spindle
  /// True: columns that a rule names may be in another file of the same record.
  bool of_several = false;
};

/// Returns all quantities that a measurement file may contain: quantities of a record, of a
/// coast-down between two speeds, of a torque sensor and of its calibration.
[[nodiscard]] std::span<const record::Channel* const> file_channels();

/// Reads a file that contains only [columns], [transducers] or both. Throws InputError like
/// read_model().
[[nodiscard]] ColumnMap read_column_map(const std::string& path);
[[nodiscard]] ColumnMap parse_column_map(std::string_view text, const std::string& source);

}  // namespace raceway::files
