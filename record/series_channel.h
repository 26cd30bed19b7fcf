#pragma once

#include <string>
#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Course of an input between two rows of a record over time.
enum class Course {
  straight,  ///< along a straight line, as temperatures do
  held       ///< as it was, as what a control has set
};

/// The quantity of a column of a record over time, null for a name that is none. A machine has as
/// many of them as it has sensors, so that they are made as they are met, once each:
/// NAME_temperature_C, NAME_feed_m_min, NAME_speed_rpm, coolant_on, setup_id, displacement_NAME_um
/// and _urad, offset_NAME_um and _urad, NAME_position_mm, NAME_current_A, NAME_voltage_V, NAME in
/// W, N, Nm, l_min, bar or percent, and of the table time_s, speed_rpm, run_id. May be called by
/// several threads at once.
[[nodiscard]] const Channel* series_channel(std::string_view name);

[[nodiscard]] Course course_of(const Channel& channel);
[[nodiscard]] bool is_temperature(const Channel& channel);
/// True for inputs that act by their amount, whatever their sign: speeds, feeds, coolant. All else
/// acts as it stands.
[[nodiscard]] bool acts_by_amount(const Channel& channel);
[[nodiscard]] bool is_position(const Channel& channel);
/// Kind of offset_NAME_um, the offset that a control added while the record was taken. The reader
/// subtracts it from the displacement; a record does not keep it.
inline constexpr std::string_view offset_kind = "offset";

/// Reading of one transducer, a length of the name NAME_um. No file has such a column by itself:
/// the combination of transducers of a model names it.
[[nodiscard]] const Channel* transducer_channel(std::string_view name);

/// Returns true for a displacement that is an angle.
[[nodiscard]] bool is_angle(const Channel& channel);
/// Returns a name or a sentence with the unit of a displacement: as it stands for a length; for an
/// angle every "um" in it becomes "urad". "gain_um_K" is gain_urad_K, "1.2 um/K" 1.2 urad/K. Both
/// units are a millionth of SI, so numbers stay.
[[nodiscard]] std::string in_unit_of(const Channel& displacement, std::string_view text);

/// True for a room temperature: the name has the word "ambient", "room" or "air".
[[nodiscard]] bool is_ambient(const Channel& channel);

}  // namespace raceway::record
