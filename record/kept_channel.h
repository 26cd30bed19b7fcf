#pragma once

#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Returns a channel for a quantity that the program does not know, such as the position of an axis
/// or the power of a motor. The name of the channel is the header, and its unit comes from the file
/// (empty if the file gives no unit). Each channel is created once. Several threads may call this
/// function at the same time.
[[nodiscard]] const Channel& kept_channel(std::string_view header, std::string_view unit);

}  // namespace raceway::record
