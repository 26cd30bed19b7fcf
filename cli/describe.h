#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// What a shell and `man` need to know of the program, made of the commands' own description: a
/// command or a flag that is declared is in all of them.
namespace raceway::cli {

/// A completion for bash: commands, flags, files, ids of effects.
[[nodiscard]] std::string bash_completion(const CLI::App& app);

/// The same for zsh, with the help of every flag beside it.
[[nodiscard]] std::string zsh_completion(const CLI::App& app);

/// The page raceway(1), which lists the commands.
[[nodiscard]] std::string man_page(const CLI::App& app);

/// The page raceway-COMMAND(1) of one of them.
[[nodiscard]] std::string man_page_of_command(const CLI::App& command);

}  // namespace raceway::cli
