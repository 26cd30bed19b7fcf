#include "cli/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/text_table.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

constexpr std::size_t widest = 100;  // longer lines are hard to read

/// A name behind two blanks, and its meaning in a column that starts at `margin`.
std::string entry(const std::string& name, std::string meaning, std::size_t margin) {
  std::replace(meaning.begin(), meaning.end(), '\n', ' ');
  const std::size_t width = std::min(terminal_width(), widest);
  std::string out, head = "  " + name;
  if (!meaning.empty() && head.size() + 2 > margin) {
    out = head + '\n';
    head.clear();
  }
  if (meaning.empty()) return head + '\n';
  for (const std::string& line : filled(meaning, std::max<std::size_t>(width, 50) - margin)) {
    out += fmt::format("{:<{}}{}\n", head, margin, line);
    head.clear();
  }
  return out;
}

}  // namespace

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
  return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
         make_subcommands(app, mode) + make_groups(app, mode) + '\n' + make_footer(app);
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  if (app->get_parent() == nullptr) return "\nUsage: " + name + " COMMAND [ARGUMENTS] [OPTIONS]\n";
  std::string usage = "\nUsage: " + name;
  for (const CLI::Option* option : app->get_options())
    if (option->get_positional()) usage += " " + make_option_usage(option);
  return usage + " [OPTIONS]\n";
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description(), 20);
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool positional) const {
  const std::string name =
      make_option_name(option, positional) + (positional ? "" : make_option_opts(option));
  return entry(
      name,
      option->get_description() + (option->get_required() && !positional ? " (required)" : ""), 25);
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_items_expected_max() == 0) return {};
  return " " + option->get_type_name() + (option->get_allow_extra_args() ? " ..." : "");
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  std::string out;
  for (const std::string& line :
       filled(app->get_description() + ".", std::min(terminal_width(), widest)))
    out += line + '\n';
  return out;
}

std::vector<const CLI::App*> listed_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::string file_as_command(std::string_view name) {
  namespace fs = std::filesystem;
  const fs::path path(name);
  const std::string ending = text::lower_case(path.extension().string());
  std::error_code ignored;
  const auto ends_as = [&](std::initializer_list<std::string_view> endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
  };
  const bool model = ends_as({".toml"});
  const bool data = ends_as({".csv", ".txt", ".dat", ".tsv", ".lvm", ".asc", ".log"});
  if (!model && !data && !fs::is_regular_file(path, ignored)) return {};
  if (model)
    return fmt::format(
        "{0} is a file; give a command first.\n"
        "To see what is in this model: raceway check {0}\n"
        "To compare it with measurements: raceway compare {0} DATA.csv\n"
        "raceway help lists all commands.",
        name);
  return fmt::format(
      "{0} is a file; give a command first. Measurements need a model:\n"
      "  raceway new \"7014 C\" --oil \"VG 32\" --law palmgren -o my.toml   for a bearing on a "
      "rig\n"
      "  raceway new --record {0} -o my.toml   for a displacement over time\n"
      "  raceway check my.toml {0}\n"
      "  raceway diagnose my.toml {0}\n"
      "raceway help lists all commands.",
      name);
}

}  // namespace raceway::cli
