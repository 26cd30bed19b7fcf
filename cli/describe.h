#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// Shell completions and man pages, generated from the declared commands and flags, so that they
/// are always complete.
namespace raceway::cli {

/// A completion for bash: commands, flags, files, ids of effects.
[[nodiscard]] std::string bash_completion(const CLI::App& app);

/// A completion for zsh, with the help text of every flag.
[[nodiscard]] std::string zsh_completion(const CLI::App& app);

/// The page raceway(1), which lists the commands.
[[nodiscard]] std::string man_page(const CLI::App& app);

/// The page raceway-COMMAND(1) of one of them.
[[nodiscard]] std::string man_page_of_command(const CLI::App& command);

}  // namespace raceway::cli
