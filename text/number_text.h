#pragma once

#include <string>
#include <string_view>

#include "record/channel.h"

/// Numbers and units as results and files have them; shared by readers and writers.
namespace raceway::text {

/// The number that 15 digits of it give, which is what results and written models show: it takes
/// the rounding of a change of unit off, 6000 rpm are not 6000.000000000001.
[[nodiscard]] double with_15_digits(double value);

/// A double as TOML: the shortest text that reads back the same, always a float.
[[nodiscard]] std::string toml_float(double value);

/// A number for people in so many significant digits, without exponent where they would write none;
/// "-" for NaN.
[[nodiscard]] std::string number(double value, int digits = 4);

/// A value of a channel in its unit, without the rounding of an offset that is larger than the
/// value: 60 C are not 59.9999999999999.
[[nodiscard]] double value_in_unit(const record::Channel& channel, double si);

/// The unit of differences, as keys have it: "Nmm", "um"; of temperatures "K".
[[nodiscard]] std::string_view difference_unit(const record::Channel& channel);

/// The key of an error that does not matter: "tolerance_Nmm".
[[nodiscard]] std::string tolerance_key(const record::Channel& channel);

}  // namespace raceway::text
