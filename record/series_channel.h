#pragma once

#include <string>
#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Shape of an input between two rows of a time record.
enum class Course {
  straight,  ///< straight line, suitable for temperatures
  held       ///< constant, suitable for settings of a control
};

/// Returns the quantity of a column of a time record; null for an unknown name. Channels are
/// created when they are first needed, because a machine may have any number of sensors. Names:
/// NAME_temperature_C, NAME_feed_m_min, NAME_speed_rpm, coolant_on, setup_id, displacement_NAME_um
/// and _urad, offset_NAME_um and _urad, NAME_position_mm, NAME_current_A, NAME_voltage_V, NAME_W,
/// NAME_N, NAME_Nm, NAME_l_min, NAME_bar and NAME_percent, and time_s, speed_rpm and run_id from
/// the table in channel.h. Several threads may call this function at the same time.
[[nodiscard]] const Channel* series_channel(std::string_view name);

[[nodiscard]] Course course_of(const Channel& channel);
[[nodiscard]] bool is_temperature(const Channel& channel);
/// Returns true for inputs that act by their absolute value: speeds, feeds, coolant. All other
/// inputs act with their sign.
[[nodiscard]] bool acts_by_amount(const Channel& channel);
[[nodiscard]] bool is_position(const Channel& channel);
/// Kind of offset_NAME_um, the offset that a control applied during the record. The file reader
/// subtracts this offset from the displacement, so the record does not contain the column.
inline constexpr std::string_view offset_kind = "offset";

/// Returns the channel of one transducer, a length with the name NAME_um. Files have this column
/// only if a model combines several transducers and names the column.
[[nodiscard]] const Channel* transducer_channel(std::string_view name);

/// Returns true for a displacement that is an angle.
[[nodiscard]] bool is_angle(const Channel& channel);
/// Converts the unit in a name or a sentence to the unit of a displacement. For a length, the text
/// is unchanged. For an angle, every unit "um" becomes "urad": "gain_um_K" becomes "gain_urad_K",
/// and "1.2 um/K" becomes "1.2 urad/K". Both units are a millionth of the SI unit, so numbers do
/// not change.
[[nodiscard]] std::string in_unit_of(const Channel& displacement, std::string_view text);

/// Returns true for an ambient temperature: the name contains the word "ambient", "room" or "air".
[[nodiscard]] bool is_ambient(const Channel& channel);

}  // namespace raceway::record
