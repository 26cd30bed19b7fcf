#pragma once

#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Returns a channel for a quantity unknown to the program, such as the position of an axis or the
/// power of a motor. It has the header as its name and the unit from the file, which is empty if
/// none is given. Each channel is created once. Several threads may call it at once.
[[nodiscard]] const Channel& kept_channel(std::string_view header, std::string_view unit);

}  // namespace raceway::record
