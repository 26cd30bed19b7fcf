#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "record/units.h"

namespace raceway::record {

/// Role of a column.
enum class Role {
  setting,    ///< set by the operator; may influence a reading
  recorded,   ///< not set by the operator; may influence a reading
  measured,   ///< reading of a sensor; a model may predict it
  deviation,  ///< standard deviation of the readings of a measured channel
  time,
  run,   ///< index of the run of a row
  part,  ///< for a record from joined(): index of the original record of a row
  kept   ///< column with an unknown name; no model uses it
};

/// Quantity that a column of a record can contain.
struct Channel {
  std::string_view name;             ///< name of the column with its unit at the end: "speed_rpm"
  std::string_view variable = name;  ///< name without unit, as in results: "speed"
  std::string_view words = name;     ///< readable name: "axial load"
  std::string_view unit = {};        ///< readable unit: "N mm"
  double factor = 1.0;               ///< SI value = factor * column value + offset
  double offset = 0.0;
  double lower = 0.0, upper = 0.0;  ///< lowest and highest allowed value, in the unit of the column
  Role role = Role::setting;
  /// Step that separates two levels of a quantity: if the values are sorted, a larger difference
  /// between neighbours begins a new level. The step is in SI units, or relative to the largest
  /// value [1] if `ratio` is true.
  double step = 0.0;
  bool ratio = false;  ///< true: `step` is relative to the largest value
  /// Kind of quantity, such as "load". In find_repeats(), a relative tolerance refers to the
  /// largest value of all channels of one kind.
  std::string_view kind = {};
  /// Text that the program prints after a value: "rpm" or "N axial load".
  std::string_view place = {};
  /// Name of the measured channel whose standard deviation this channel contains; empty for other
  /// channels.
  std::string_view of = {};
  /// Sign convention of a measured channel, as text: "positive towards the tool".
  std::string_view direction = {};

  [[nodiscard]] constexpr double to_SI(double value) const { return value * factor + offset; }
  [[nodiscard]] constexpr double in_unit(double si) const { return (si - offset) / factor; }
  /// Returns the unit in the spelling of column names and keys: "Nmm".
  [[nodiscard]] constexpr std::string_view key_unit() const {
    return name.size() > variable.size() ? name.substr(variable.size() + 1) : std::string_view();
  }
  /// Returns true if the quantity may influence a reading.
  [[nodiscard]] constexpr bool is_input() const {
    return role == Role::setting || role == Role::recorded;
  }
  [[nodiscard]] constexpr bool operator==(const Channel& other) const { return name == other.name; }
};

inline constexpr double endless = std::numeric_limits<double>::max();

/// All quantities with a fixed column name. The list begins with the speed, because the speed
/// varies in most records.
inline constexpr std::array channels{Channel{.name = "speed_rpm",
                                             .variable = "speed",
                                             .words = "speed",
                                             .unit = "rpm",
                                             .factor = rpm,
                                             .lower = 0,
                                             .upper = 1e6,
                                             .step = 5e-3,
                                             .ratio = true,
                                             .place = "rpm"},
                                     Channel{.name = "axial_load_N",
                                             .variable = "axial_load",
                                             .words = "axial load",
                                             .unit = "N",
                                             .lower = 0,
                                             .upper = 1e8,
                                             .step = 5e-3,
                                             .ratio = true,
                                             .kind = "load",
                                             .place = "N axial load"},
                                     Channel{.name = "radial_load_N",
                                             .variable = "radial_load",
                                             .words = "radial load",
                                             .unit = "N",
                                             .lower = 0,
                                             .upper = 1e8,
                                             .step = 5e-3,
                                             .ratio = true,
                                             .kind = "load",
                                             .place = "N radial load"},
                                     Channel{.name = "temperature_C",
                                             .variable = "temperature",
                                             .words = "temperature",
                                             .unit = "C",
                                             .offset = celsius_zero,
                                             .lower = -273,
                                             .upper = 500,
                                             .step = 0.5,
                                             .place = "C"},
                                     Channel{.name = "preload_N",
                                             .variable = "preload",
                                             .words = "preload",
                                             .unit = "N",
                                             .lower = 0,
                                             .upper = 1e8,
                                             .step = 5e-3,
                                             .ratio = true,
                                             .place = "N preload"},
                                     Channel{.name = "inner_ring_temperature_C",
                                             .variable = "inner_ring_temperature",
                                             .words = "inner ring temperature",
                                             .unit = "C",
                                             .offset = celsius_zero,
                                             .lower = -273,
                                             .upper = 500,
                                             .role = Role::recorded,
                                             .step = 0.5,
                                             .place = "C inner ring temperature"},
                                     Channel{.name = "outer_ring_temperature_C",
                                             .variable = "outer_ring_temperature",
                                             .words = "outer ring temperature",
                                             .unit = "C",
                                             .offset = celsius_zero,
                                             .lower = -273,
                                             .upper = 500,
                                             .role = Role::recorded,
                                             .step = 0.5,
                                             .place = "C outer ring temperature"},
                                     Channel{.name = "time_s",
                                             .variable = "time",
                                             .words = "time",
                                             .unit = "s",
                                             .lower = -endless,
                                             .upper = endless,
                                             .role = Role::time},
                                     Channel{.name = "run_id",
                                             .variable = "run",
                                             .words = "run",
                                             .unit = "",
                                             .role = Role::run,
                                             .step = 0.5},
                                     Channel{.name = "friction_torque_Nmm",
                                             .variable = "friction_torque",
                                             .words = "friction torque",
                                             .unit = "N mm",
                                             .factor = N_mm,
                                             .lower = -1e9,
                                             .upper = 1e9,
                                             .role = Role::measured},
                                     Channel{.name = "axial_displacement_um",
                                             .variable = "axial_displacement",
                                             .words = "axial displacement",
                                             .unit = "um",
                                             .factor = um,
                                             .lower = -1e6,
                                             .upper = 1e6,
                                             .role = Role::measured,
                                             .direction = "positive towards the tool"},
                                     // A standard deviation of zero is not allowed: it would give
                                     // its reading an infinite weight.
                                     Channel{.name = "std_Nmm",
                                             .variable = "std",
                                             .words = "standard deviation",
                                             .unit = "N mm",
                                             .factor = N_mm,
                                             .lower = 1e-9,
                                             .upper = 1e9,
                                             .role = Role::deviation,
                                             .of = "friction_torque_Nmm"},
                                     Channel{.name = "std_um",
                                             .variable = "std",
                                             .words = "standard deviation",
                                             .unit = "um",
                                             .factor = um,
                                             .lower = 1e-9,
                                             .upper = 1e6,
                                             .role = Role::deviation,
                                             .of = "axial_displacement_um"}};

/// Returns the channel with this name in `channels`; null if there is none.
[[nodiscard]] constexpr const Channel* find_channel(std::string_view name) {
  for (const Channel& channel : channels)
    if (channel.name == name) return &channel;
  return nullptr;
}

// Channels that the code uses by name.
inline constexpr const Channel& speed = *find_channel("speed_rpm");
inline constexpr const Channel& axial_load = *find_channel("axial_load_N");
inline constexpr const Channel& radial_load = *find_channel("radial_load_N");
inline constexpr const Channel& temperature = *find_channel("temperature_C");
inline constexpr const Channel& preload = *find_channel("preload_N");
inline constexpr const Channel& inner_ring_temperature = *find_channel("inner_ring_temperature_C");
inline constexpr const Channel& outer_ring_temperature = *find_channel("outer_ring_temperature_C");
inline constexpr const Channel& time = *find_channel("time_s");
inline constexpr const Channel& run = *find_channel("run_id");
inline constexpr const Channel& friction_torque = *find_channel("friction_torque_Nmm");
inline constexpr const Channel& axial_displacement = *find_channel("axial_displacement_um");
inline constexpr const Channel& torque_deviation = *find_channel("std_Nmm");
inline constexpr const Channel& displacement_deviation = *find_channel("std_um");

/// Channel of a column that joined() adds: index of the original record of each row. Files do not
/// contain this column.
inline constexpr Channel part{.name = "record", .words = "record", .role = Role::part, .step = 0.5};

}  // namespace raceway::record
