#pragma once

#include <string>

#include "cli/text_table.h"
#include "record/channel.h"
#include "verdict/compare.h"
#include "verdict/verdict_text.h"

namespace raceway::cli {

/// Returns the unit of errors on a channel, for people: K for temperatures.
[[nodiscard]] inline std::string error_unit(const record::Channel& channel) {
  return std::string(verdict::unit_of_difference(channel));
}

/// Converts an error [SI] to that unit; the text omits the unit.
[[nodiscard]] inline std::string error_text(double error, const record::Channel& channel,
                                            int digits = 4) {
  return number(error / channel.factor, digits);
}

/// Returns the noise of the data of a comparison with its source, or why it is not known.
[[nodiscard]] std::string noise_text(const verdict::Comparison& comparison);

/// Number of channels from which the errors are printed as one table.
inline constexpr std::size_t many_channels = 3;

}  // namespace raceway::cli
