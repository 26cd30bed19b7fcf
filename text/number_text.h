#pragma once

#include <string>
#include <string_view>

#include "record/channel.h"

/// Functions that write numbers and units as text, for results and files.
namespace raceway::text {

/// Rounds a number to 15 digits, as in results and written models. This removes the rounding errors
/// of unit conversions: 6000 rpm instead of 6000.000000000001.
[[nodiscard]] double with_15_digits(double value);

/// Returns a number as a TOML float: the shortest text that is read as exactly the same number.
[[nodiscard]] std::string toml_float(double value);

/// Returns a number as text for the user, with `digits` significant digits. The text has an
/// exponent only for very large and very small numbers. NaN gives "-".
[[nodiscard]] std::string number(double value, int digits = 4);

/// Converts the SI value `si` to the unit of the channel. If the conversion has an offset (K to C),
/// the function removes the rounding error: 60 C instead of 59.9999999999999.
[[nodiscard]] double value_in_unit(const record::Channel& channel, double si);

/// Returns the unit of differences between values of a channel, spelled as in the keys of model
/// files: "Nmm", "um"; "K" for temperatures.
[[nodiscard]] std::string_view difference_unit(const record::Channel& channel);

/// Returns the key of the tolerance of a channel: "tolerance_Nmm".
[[nodiscard]] std::string tolerance_key(const record::Channel& channel);

}  // namespace raceway::text
