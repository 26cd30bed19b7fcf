#include "cli/describe.h"

#include <fmt/core.h>

#include <filesystem>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/messages.h"
#include "text/error.h"
#include "text/names.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

struct DescribeFlags {
  std::string format, command, tree;
};

const CLI::App& find_command(const CLI::App& app, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::App* known : listed_commands(app)) {
    if (known->get_name() == name) return *known;
    names.push_back(known->get_name());
  }
  throw text::InputError(
      "raceway describe: " + name + ": no such command" + text::suggestion(name, names),
      {.key = "COMMAND"});
}

/// As below share/ of an installation.
void write_tree(const CLI::App& app, const std::filesystem::path& folder) {
  const auto write = [&](const std::filesystem::path& file, const std::string& text) {
    const std::filesystem::path path = folder / file;
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    text::write_text(path.string(), text, text::IfExists::replace);
  };
  write("bash-completion/completions/raceway", bash_completion(app));
  write("zsh/site-functions/_raceway", zsh_completion(app));
  write("man/man1/raceway.1", man_page(app));
  for (const CLI::App* command : listed_commands(app))
    write("man/man1/raceway-" + command->get_name() + ".1", man_page_of_command(*command));
}

int run(const CLI::App& app, const DescribeFlags& flags) {
  if (!flags.tree.empty()) {
    write_tree(app, flags.tree);
    say(flags.tree + " written");
    return done;
  }
  if (flags.format == "bash")
    fmt::print("{}", bash_completion(app));
  else if (flags.format == "zsh")
    fmt::print("{}", zsh_completion(app));
  else if (flags.format == "man")
    fmt::print("{}", flags.command.empty() ? man_page(app)
                                           : man_page_of_command(find_command(app, flags.command)));
  else
    throw text::InputError("raceway describe: FORMAT must be bash, zsh or man", {.key = "FORMAT"});
  return done;
}

}  // namespace

Run setup_describe(CLI::App& command) {
  auto flags = std::make_shared<DescribeFlags>();
  command.add_option("FORMAT", flags->format, "bash or zsh: shell completion; man: man page")
      ->type_name("");
  command.add_option("COMMAND", flags->command, "with man: command that the page describes")
      ->type_name("");
  command
      .add_option(
          "--tree", flags->tree,
          "write all completions and man pages into the subfolders of share/ in this folder")
      ->type_name("FOLDER");
  command.footer(
      "Example:\n  raceway describe bash > ~/.local/share/bash-completion/completions/raceway\n"
      "  raceway describe man solve | man -l -");
  return [flags, &command] { return run(*command.get_parent(), *flags); };
}

}  // namespace raceway::cli
