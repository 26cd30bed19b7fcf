#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>

#include "text/number_range.h"

namespace raceway::cli {

using text::load_range;
using text::moment_range;
using text::NumberRange;
using text::power_range;
using text::require_range;
using text::signed_load_range;
using text::speed_range;
using text::temperature_range;

/// Declares a flag with one number in a range. `value` is unchanged if the flag is not given.
/// When the command line is parsed, text::InputError is thrown for a text that is not a number and
/// for a number outside the range.
CLI::Option* add_number(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help);

/// Throws text::InputError for numbers that have two possible meanings. For example, 1.200 is 1.2
/// in English and 1200 in German. If 1200 is outside the range, the function accepts 1.200 as 1.2.
void ask_about_thousands(std::span<const std::string_view> numbers, const NumberRange& range,
                         const std::string& flag);

/// Declares a flag with a length: "70", "70mm", "2.7559in". The unit is mm if none is given.
/// `value` is in m.
CLI::Option* add_length(CLI::App& command, const std::string& flag, double& value,
                        const NumberRange& range, const std::string& help);

}  // namespace raceway::cli
