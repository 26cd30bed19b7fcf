#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// Writes shell completions and man pages of the command-line program. All texts are generated from
/// the declared commands and flags.
namespace raceway::cli {

/// Returns a completion for bash with commands, flags, files and ids of effects.
[[nodiscard]] std::string bash_completion(const CLI::App& app);

/// Returns a completion for zsh with the help text of every flag.
[[nodiscard]] std::string zsh_completion(const CLI::App& app);

/// Returns the page raceway(1), which lists the commands.
[[nodiscard]] std::string man_page(const CLI::App& app);

/// Returns the page raceway-COMMAND(1) of one command.
[[nodiscard]] std::string man_page_of_command(const CLI::App& command);

}  // namespace raceway::cli
