#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace raceway::io {

/// A date with a time as seconds since 1970, leap seconds left out: "2024-03-12T08:15:00.5+01:00"
/// (ISO 8601; a blank for the T, Z, no seconds) and "12.03.2024 08:15:00,5". Nothing for all else.
[[nodiscard]] std::optional<double> parse_timestamp(std::string_view cell);

/// Days since 1900 as Excel counts them (60 is a 29 February 1900 that never was), as seconds since
/// 1970. Nothing outside of the years that Excel has, 1900 to 9999.
[[nodiscard]] std::optional<double> seconds_of_excel(double days);

/// "2024-03-12T08:15:00.5"; of the years 0 to 9999.
[[nodiscard]] std::string timestamp_text(double seconds);

}  // namespace raceway::io
