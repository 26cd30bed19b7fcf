#pragma once

#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Returns a channel for a column whose name the program does not know. `header` is the name of the
/// column in the file and becomes the name of the channel. `unit` is the unit that the file gives;
/// it is empty if the file gives no unit. Calls with the same header and unit return the same
/// channel. Several threads may call this function at the same time.
[[nodiscard]] const Channel& kept_channel(std::string_view header, std::string_view unit);

}  // namespace raceway::record
