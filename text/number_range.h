#pragma once

#include <string>
#include <string_view>

namespace raceway::text {

/// Allowed range of a number that the user enters, in `unit`. Both limits are allowed.
struct NumberRange {
  double lower, upper;
  std::string_view unit;
};

inline constexpr NumberRange speed_range{0.0, 1e6, "rpm"};
inline constexpr NumberRange load_range{0.0, 1e8, "N"};
inline constexpr NumberRange power_range{0.0, 1e7, "W"};
/// Range of loads on a shaft, which can be negative.
inline constexpr NumberRange signed_load_range{-1e8, 1e8, "N"};
inline constexpr NumberRange temperature_range{-100.0, 400.0, "C"};
inline constexpr NumberRange moment_range{-1e9, 1e9, "N mm"};

/// Returns the range as text, such as "must be from 0 to 1000000 rpm".
[[nodiscard]] std::string range_text(const NumberRange& range);

/// Throws InputError with name, value and range if the number is outside its range.
void require_range(double value, const NumberRange& range, const std::string& name);

}  // namespace raceway::text
