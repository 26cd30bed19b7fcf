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

/// Conversion of a cell to SI.
struct CellUnit {
  const text::Unit* unit = nullptr;  ///< null: the unit of the channel
  double factor = 1.0;               ///< the user's factor, applied first: -1 changes the sign

  [[nodiscard]] double to_SI(const record::Channel& channel, double cell) const {
    return unit ? unit->to_SI(cell * factor) : channel.to_SI(cell * factor);
  }
  [[nodiscard]] double in_cell(const record::Channel& channel, double si) const {
    return (unit ? unit->in_unit(si) : channel.in_unit(si)) / factor;
  }
};

/// A channel identified by a column name in a file.
struct NamedChannel {
  const record::Channel* channel;
  const text::Unit* unit =
      nullptr;  ///< null: the unit is the unit of the channel, or the channel has no unit
};

/// Returns the unit of a channel from the table of units; null for a channel without a unit (a run,
/// a count).
[[nodiscard]] const text::Unit* unit_of(const record::Channel& channel);

/// Returns the channel with this name; nothing if there is none. The name may have another unit of
/// the same dimension: "friction_torque_Nm", "speed [1/min]".
[[nodiscard]] std::optional<NamedChannel> named_channel(
    std::string_view name, std::span<const record::Channel* const> channels);

/// Works like named_channel(), for a quantity of records over time: "front_bearing_temperature_K",
/// "displacement_z [mm]".
[[nodiscard]] std::optional<NamedChannel> named_series_channel(std::string_view name);

/// Works like named_channel(), for a record of a spindle. All temperatures of a spindle count as
/// measured, except temperatures of the surroundings.
[[nodiscard]] std::optional<NamedChannel> named_spindle_channel(std::string_view name);

/// One line of [columns]. The line states the source of one channel.
struct ColumnRule {
  std::string key;                   ///< as written in [columns]: "friction_torque_Nmm"
  const record::Channel* channel;    ///< channel that the key names
  const text::Unit* key_unit;        ///< unit at the end of the key; null: the unit of the channel
  std::string header{};              ///< header of the user's column; empty for a constant
  std::optional<double> constant{};  ///< value for all rows, in the unit of the key
  const text::Unit* unit = nullptr;  ///< unit of the user's column, if the rule states it
  bool excel_date = false;           ///< true: the numbers are days since 1900, as in Excel
  double factor = 1.0;               ///< factor that multiplies the numbers
  text::Place place{};               ///< place of the rule in the file
};

/// One line of [transducers]: a displacement as a sum of readings of transducers.
struct Combination {
  struct Term {
    const record::Channel* transducer;
    double factor;  ///< [m/m]; for an angle [rad/m]
  };
  const record::Channel* displacement;
  std::vector<Term> terms{};
  text::Place place{};
};

/// The tables [columns] and [transducers], from a model or from a separate file.
struct ColumnMap {
  std::string source{};
  std::vector<ColumnRule> rules{};
  char decimal_mark = '\0';                     ///< decimal mark of the file; '\0': not given
  std::optional<text::DateOrder> date_order{};  ///< order of day and month in dates with slashes
  std::optional<record::SettingsHold> settings_hold{};  ///< only for a record over time
  std::vector<Combination> transducers{};               ///< only for a record over time

  [[nodiscard]] const ColumnRule* find(std::string_view header) const;
  /// Returns the transducer with this name, in any unit of length: "x1_um", "x1 [nm]".
  [[nodiscard]] std::optional<NamedChannel> find_transducer(std::string_view name) const;
};

/// Options for reading a file of measurements.
struct ReadOptions {
  ColumnMap columns{};
  /// Calibration that converts a column torque_signal_V to friction torque.
  std::optional<rig::TorqueSensor> sensor{};
  bool drop_nan = false;    ///< true: rows with a missing number are omitted and reported
  bool over_time = false;   ///< true: the file is a record over time
  bool of_spindle = false;  ///< true: the file is a record of a spindle over time
  bool of_several = false;  ///< true: columns of the map may be in another file of the same record
};

/// Returns all channels that a file may have: channels of a record, of a fall between two speeds,
/// of a torque sensor and of its calibration.
[[nodiscard]] std::span<const record::Channel* const> file_channels();

/// Reads a file with only [columns], [transducers] or both. Throws InputError like read_model().
[[nodiscard]] ColumnMap read_column_map(const std::string& path);
[[nodiscard]] ColumnMap parse_column_map(std::string_view text, const std::string& source);

}  // namespace raceway::files
