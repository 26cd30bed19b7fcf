#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/describe.h"
#include "cli/help.h"

namespace raceway::cli {
namespace {

/// Text that roff takes as it stands: no control line, no escape, hyphens that can be searched.
std::string roff(std::string_view text) {
  std::string result;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
    line_start = c == '\n';
  }
  return result;
}

std::string head(const std::string& name, const std::string& summary) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return fmt::format(".TH {} 1 \"\" \"raceway {}\" \"raceway\"\n.SH NAME\n{} \\- {}\n", roff(title),
                     RACEWAY_VERSION, roff(name), roff(summary));
}

/// "-o, --output FILE" and its help.
std::string entry(const CLI::Option& option) {
  std::string names;
  const auto add = [&](const std::string& name) {
    names += (names.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
  };
  if (option.get_positional()) {
    add(option.get_name());
  } else {
    for (const std::string& name : option.get_snames()) add("-" + name);
    for (const std::string& name : option.get_lnames()) add("--" + name);
    if (option.get_items_expected_max() > 0)
      names += " \\fI" + roff(option.get_type_name()) + "\\fR";
  }
  return fmt::format(".TP\n{}\n{}{}\n", names, roff(option.get_description()),
                     option.get_required() ? " (required)" : "");
}

/// Prose, then the examples, which keep their lines.
std::string footer(const CLI::App& app) {
  const std::string text = app.get_footer();
  constexpr std::string_view mark = "Example:\n";
  const std::size_t at = std::min(text.find(mark), text.size());
  std::string result;
  if (at > 0)
    result += ".SH NOTES\n.nf\n" + roff(text.substr(0, text.find_last_not_of('\n', at - 1) + 1)) +
              "\n.fi\n";
  if (at < text.size())
    result += ".SH EXAMPLE\n.nf\n" + roff(text.substr(at + mark.size())) + "\n.fi\n";
  return result;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  std::string text = head("raceway", app.get_description());
  text += ".SH SYNOPSIS\n.B raceway\n.I COMMAND\n[\\fIARGUMENT\\fR ...]\n.SH COMMANDS\n";
  for (const CLI::App* command : listed_commands(app))
    text += fmt::format(".TP\n.BR raceway\\-{} (1)\n{}\n", roff(command->get_name()),
                        roff(command->get_description()));
  text += ".SH OPTIONS\n";
  for (const CLI::Option* option : app.get_options()) text += entry(*option);
  return text + footer(app);
}

std::string man_page_of_command(const CLI::App& command) {
  std::string text = head("raceway-" + command.get_name(), command.get_description());
  std::string arguments, flags, synopsis;
  for (const CLI::Option* option : command.get_options()) {
    (option->get_positional() ? arguments : flags) += entry(*option);
    if (!option->get_positional()) continue;
    const bool several = option->get_items_expected_max() > 1;
    const std::string name = "\\fI" + roff(option->get_name()) + "\\fR" + (several ? " ..." : "");
    synopsis += option->get_required() ? " " + name : " [" + name + "]";
  }
  text += fmt::format(".SH SYNOPSIS\n\\fBraceway {}\\fR{} [\\fIOPTION\\fR ...]\n",
                      roff(command.get_name()), synopsis);
  if (!arguments.empty()) text += ".SH ARGUMENTS\n" + arguments;
  text += ".SH OPTIONS\n" + flags + footer(command);
  return text + ".SH SEE ALSO\n.BR raceway (1)\n";
}

}  // namespace raceway::cli
