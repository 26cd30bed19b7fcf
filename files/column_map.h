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
  const text::Unit* unit = nullptr;  ///< unit of the number; null means the unit of the channel
  /// Factor that multiplies the number in the file; -1 changes the sign.
  double factor = 1.0;

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
  /// Unit in the column name; null if the name has no unit or has the unit of the channel.
  const text::Unit* unit = nullptr;
};

/// Returns the unit of a channel; null for a channel without a unit, such as a run number.
[[nodiscard]] const text::Unit* unit_of(const record::Channel& channel);

/// Returns the quantity in `channels` that has this name; empty if there is none. The name may
/// contain another unit of the same dimension: "friction_torque_Nm", "speed [1/min]".
[[nodiscard]] std::optional<NamedChannel> named_channel(
    std::string_view name, std::span<const record::Channel* const> channels);

/// Returns the quantity with this name in a time record, like named_channel(): for example
/// "front_bearing_temperature_K" or "displacement_z [mm]".
[[nodiscard]] std::optional<NamedChannel> named_series_channel(std::string_view name);

/// Returns the quantity with this name in a spindle record, like named_channel(). In a spindle
/// record, temperatures of the surroundings are inputs, and all other temperatures are measured
/// quantities.
[[nodiscard]] std::optional<NamedChannel> named_spindle_channel(std::string_view name);

/// One entry of the table [columns] in a model file. The entry states which column of a measurement
/// file contains a quantity, or gives a constant value for the quantity. A line with a list of
/// columns gives one rule for each column.
struct ColumnRule {
  std::string key;                 ///< key as written in [columns]: "friction_torque_Nmm"
  const record::Channel* channel;  ///< quantity of this key
  /// Unit at the end of the key; null means the unit of the channel.
  const text::Unit* key_unit;
  std::string header{};              ///< header of the user's column; empty for a constant
  std::optional<double> constant{};  ///< value for all rows, in the unit of the key
  const text::Unit* unit = nullptr;  ///< unit of the user's column, if [columns] states it
  bool excel_date = false;           ///< true: the times are days since 1900, as in Excel
  double factor = 1.0;               ///< factor that multiplies the numbers in the column
  text::Place place{};               ///< file and line number of this line
};

/// One line of the table [transducers]: a displacement as a weighted sum of transducer readings.
struct Combination {
  struct Term {
    const record::Channel* transducer;
    /// Factor that multiplies the reading: [m/m] for a displacement, [rad/m] for an angle.
    double factor;
  };
  const record::Channel* displacement;
  std::vector<Term> terms{};
  text::Place place{};
};

/// The tables [columns] and [transducers] of a model file or of a separate file.
struct ColumnMap {
  std::string source{};
  std::vector<ColumnRule> rules{};
  /// Decimal mark of the file; '\0' if it is not given.
  char decimal_mark = '\0';
  std::optional<text::DateOrder> date_order{};  ///< order of day and month in dates with slashes
  /// Time interval in which the settings of a row, such as the speed, are valid. Used only for a
  /// time record. Default: SettingsHold::until_row (from the previous row to this row) for a
  /// spindle, and SettingsHold::sampled (from this row to the next row) for other models.
  std::optional<record::SettingsHold> settings_hold{};
  std::vector<Combination> transducers{};  ///< only for a time record

  [[nodiscard]] const ColumnRule* find(std::string_view header) const;
  /// Returns the headers in the rules for this quantity as a text with quotes: "Zeit" or "Time".
  [[nodiscard]] std::string headers_of(const record::Channel& channel) const;
  /// Returns the transducer in [transducers] with this name, which may end with any unit of length,
  /// such as "x1_um" or "x1 [nm]"; empty if there is none.
  [[nodiscard]] std::optional<NamedChannel> find_transducer(std::string_view name) const;
};

/// Options for reading a file of measurements.
struct ReadOptions {
  ColumnMap columns{};
  /// Calibration for the conversion of the column torque_signal_V to friction torque.
  std::optional<rig::TorqueSensor> sensor{};
  bool drop_nan = false;    ///< true: rows with a missing number are omitted, with a note
  bool over_time = false;   ///< true: the file is a time record
  bool of_spindle = false;  ///< true: the file is a time record of a spindle
  /// True: the record has several files, and a column named in [columns] may be in any of them.
  bool of_several = false;
  /// True: the time record may lack a measured column that [columns] names.
  bool without_readings = false;
};

/// Returns all quantities that a measurement file may contain. These include the coast-down time
/// between two speeds, the signal of a torque sensor, and the readings for the calibration of the
/// sensor.
[[nodiscard]] std::span<const record::Channel* const> file_channels();

/// Reads a file with the table [columns], the table [transducers] or both, and no other table.
/// Throws InputError if the file cannot be read or is not valid.
[[nodiscard]] ColumnMap read_column_map(const std::string& path);
[[nodiscard]] ColumnMap parse_column_map(std::string_view text, const std::string& source);

}  // namespace raceway::files
