#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

namespace raceway::cli {

struct FlagProblem {
  std::string flag, what;  ///< name of the flag, and the error message (`what`)
};

/// Finds the first error in the flags of a command: a flag is unknown, is given twice, or has no
/// value. For an unknown flag, the message suggests a similar flag. Call this function before the
/// command line is parsed. If a required flag is misspelt, the parser only reports that the flag is
/// missing.
[[nodiscard]] std::optional<FlagProblem> flag_problem(const CLI::App& command,
                                                      std::span<char* const> arguments);

/// Returns the name of a required argument or flag that is missing in the parsed command line;
/// empty if none is missing.
[[nodiscard]] std::string missing_name(const CLI::App& command);

}  // namespace raceway::cli
