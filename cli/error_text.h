#pragma once

#include <string>

#include "cli/text_table.h"
#include "record/channel.h"
#include "verdict/compare.h"
#include "verdict/verdict_text.h"

namespace raceway::cli {

/// Returns the unit in which errors of a channel are printed, for example K for temperatures.
[[nodiscard]] inline std::string error_unit(const record::Channel& channel) {
  return std::string(verdict::unit_of_difference(channel));
}

/// Returns an error [SI] as text, in the unit that error_unit() returns. The text does not contain
/// the unit.
[[nodiscard]] inline std::string error_text(double error, const record::Channel& channel,
                                            int digits = 4) {
  return number(error / channel.factor, digits);
}

/// Returns a text with the noise of the readings and the source of the noise value. If the noise is
/// not known, the text gives the reason.
[[nodiscard]] std::string noise_text(const verdict::Comparison& comparison);

/// Smallest number of measured channels for which the program prints the errors as one table.
inline constexpr std::size_t many_channels = 3;

}  // namespace raceway::cli
