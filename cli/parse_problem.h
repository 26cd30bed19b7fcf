#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

namespace raceway::cli {

struct FlagProblem {
  std::string flag, what;  ///< `what` is the message; it also contains the flag
};

/// Finds the first error in the flags of a command: a flag is unknown (the message suggests a
/// similar one), is given twice, or has no value. Call it before parsing. For a misspelt required
/// flag, the parser would only report that the required flag is missing.
[[nodiscard]] std::optional<FlagProblem> flag_problem(const CLI::App& command,
                                                      std::span<char* const> arguments);

/// Returns the required argument or flag that parsing did not find; empty if none is missing.
[[nodiscard]] std::string missing_name(const CLI::App& command);

}  // namespace raceway::cli
