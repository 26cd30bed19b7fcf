#pragma once

#include <string>

#include "cli/text_table.h"
#include "record/channel.h"

namespace raceway::cli {

/// The unit of errors on a channel, for people: temperatures differ by K.
[[nodiscard]] inline std::string error_unit(const record::Channel& channel) {
  return channel.offset == 0.0 ? std::string(channel.unit) : "K";
}

/// An error [SI] in that unit, without it.
[[nodiscard]] inline std::string error_text(double error, const record::Channel& channel,
                                            int digits = 4) {
  return number(error / channel.factor, digits);
}

/// Number of channels from which they are lines of one table.
inline constexpr std::size_t many_channels = 3;

}  // namespace raceway::cli
