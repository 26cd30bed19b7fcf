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

/// Returns an error [SI] as text in the unit error_unit(). The text does not contain the unit.
[[nodiscard]] inline std::string error_text(double error, const record::Channel& channel,
                                            int digits = 4) {
  return number(error / channel.factor, digits);
}

/// Returns the noise of the compared data and its source, or the reason why the noise is not known.
[[nodiscard]] std::string noise_text(const verdict::Comparison& comparison);

/// If a record has at least this number of channels, their errors are printed as one table.
inline constexpr std::size_t many_channels = 3;

}  // namespace raceway::cli
