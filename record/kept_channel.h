#pragma once

#include <string_view>

#include "record/channel.h"

namespace raceway::record {

/// Returns a channel for a column whose name the program does not know. `header` is the name of the
/// column and of the channel. `unit` comes from the file; it may be empty. Equal arguments give the
/// same channel. Several threads may call this function at the same time.
[[nodiscard]] const Channel& kept_channel(std::string_view header, std::string_view unit);

}  // namespace raceway::record
