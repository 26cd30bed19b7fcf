#pragma once

#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// A quantity of a file that this program does not know, as the position of an axis or the power
/// of a motor: under its header, in the unit of its file, which is empty where it states none.
/// Made once each. May be called by several threads at once.
[[nodiscard]] const Channel& kept_channel(std::string_view header, std::string_view unit);

}  // namespace raceway::record
