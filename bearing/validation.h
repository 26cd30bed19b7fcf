#pragma once

#include <string_view>

namespace raceway::bearing {

/// Throws std::invalid_argument with the message of require_between().
[[noreturn]] void refuse(std::string_view name, double value, double lower, double upper,
                         double unit, std::string_view unit_name);

/// Throws std::invalid_argument if the value is outside `lower` to `upper` or is NaN (missing). The
/// message gives name, value and range in the unit `unit_name`, for example `ball_diameter = -12
/// mm: must be from 0.5 to 200 mm`. `unit` is the size of this unit in SI units.
inline void require_between(std::string_view name, double value, double lower, double upper,
                            double unit, std::string_view unit_name) {
  if (!(value >= lower && value <= upper)) refuse(name, value, lower, upper, unit, unit_name);
}

}  // namespace raceway::bearing
