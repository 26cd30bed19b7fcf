#pragma once

#include <string>
#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Assumed change of an input between two rows of a time record.
enum class Course {
  straight,  ///< straight line between two rows; used for temperatures
  held       ///< constant between two rows; used for all other inputs
};

/// Returns the channel of a column of a time record; null for an unknown name. Several threads may
/// call this function at the same time. NAME is any name of letters, digits, "_" and "-". Known
/// names:
///   time_s, run_id, setup_id, speed_rpm, coolant_on
///   NAME_temperature_C, NAME_feed_m_min, NAME_speed_rpm, NAME_position_mm
///   displacement_NAME_um, displacement_NAME_urad, offset_NAME_um, offset_NAME_urad
///   NAME_current_A, NAME_voltage_V, NAME_W, NAME_N, NAME_Nm
///   NAME_l_min, NAME_bar, NAME_percent
[[nodiscard]] const Channel* series_channel(std::string_view name);

[[nodiscard]] Course course_of(const Channel& channel);
[[nodiscard]] bool is_temperature(const Channel& channel);
/// Returns true for speeds, feeds and the coolant. A correction uses the absolute value of these
/// inputs, and all other inputs with their sign.
[[nodiscard]] bool acts_by_amount(const Channel& channel);
[[nodiscard]] bool is_position(const Channel& channel);
/// Channel::kind of the columns offset_NAME_um and offset_NAME_urad: the offset that a machine
/// control applied while the file was recorded. The file reader subtracts this offset from the
/// displacement, so a record does not contain the column.
inline constexpr std::string_view offset_kind = "offset";

/// Returns the channel of a displacement transducer with the column name NAME_um; null for any
/// other name. Only the table [transducers] of a model file can use such a column. This table
/// calculates a displacement from the readings of several transducers.
[[nodiscard]] const Channel* transducer_channel(std::string_view name);

/// Returns true for a displacement channel that measures an angle.
[[nodiscard]] bool is_angle(const Channel& channel);
/// Replaces the unit "um" in a name or a sentence by the unit of a displacement. For a length, the
/// text is unchanged. For an angle, every unit "um" becomes "urad": "gain_um_K" becomes
/// "gain_urad_K", and "1.2 um/K" becomes "1.2 urad/K". Both units are a millionth of the SI unit,
/// so the numbers in the text remain correct.
[[nodiscard]] std::string in_unit_of(const Channel& displacement, std::string_view text);

/// Returns true for an ambient temperature: a temperature whose name contains the word "ambient",
/// "room" or "air".
[[nodiscard]] bool is_ambient(const Channel& channel);

}  // namespace raceway::record
