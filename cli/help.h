#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

/// Help texts that fit the terminal, and a message for a user who gives a file instead of a
/// command.
namespace raceway::cli {

/// Writes help with two columns, names and meanings, wrapped at the width of the terminal.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { label("Positionals", "Arguments"); }
  [[nodiscard]] std::string make_help(const CLI::App* app, std::string name,
                                      CLI::AppFormatMode mode) const override;
  [[nodiscard]] std::string make_usage(const CLI::App* app, std::string name) const override;
  [[nodiscard]] std::string make_subcommand(const CLI::App* command) const override;
  [[nodiscard]] std::string make_option(const CLI::Option* option, bool positional) const override;
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
  [[nodiscard]] std::string make_description(const CLI::App* app) const override;
};

/// Returns the commands in the order in which help texts, completions and man pages list them.
/// Hidden commands are left out.
[[nodiscard]] std::vector<const CLI::App*> listed_commands(const CLI::App& app);

/// Returns a message with suitable commands if the user gave a file instead of a command. The
/// message is empty if `name` is not a file and does not look like a file name.
[[nodiscard]] std::string file_as_command(std::string_view name);

}  // namespace raceway::cli
