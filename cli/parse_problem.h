#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace raceway::cli {

/// What is wrong with the flags among the arguments of a command: unknown (with the nearest name),
/// given twice, or without its value. Empty if nothing is. To be asked before parsing, which would
/// first complain about what is missing because of a misspelt flag.
[[nodiscard]] std::string flag_problem(const CLI::App& command, std::span<char* const> arguments);

}  // namespace raceway::cli
