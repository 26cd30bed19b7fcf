#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace raceway::cli {

/// What a number on the command line may be, both ends included, in the unit of the flag.
struct NumberRange {
  double lower, upper;
  std::string_view unit;
};

inline constexpr NumberRange speed_range{0.0, 1e6, "rpm"};
inline constexpr NumberRange load_range{0.0, 1e8, "N"};
/// On a shaft, whose loads have a direction.
inline constexpr NumberRange signed_load_range{-1e8, 1e8, "N"};
inline constexpr NumberRange temperature_range{-100.0, 400.0, "C"};
inline constexpr NumberRange moment_range{-1e9, 1e9, "N mm"};

/// Throws io::InputError that names flag, value and range.
void require_range(double value, const NumberRange& range, const std::string& flag);

/// A flag that takes one number of a range; `value` keeps what it has where the flag is not given.
/// Parsing throws io::InputError for anything else.
CLI::Option* add_number(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help);

/// The same of a length, with its unit behind it where that is not mm: "70", "70mm", "2.7559in";
/// `value` is in m.
CLI::Option* add_length(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help);

}  // namespace raceway::cli
