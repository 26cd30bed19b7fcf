#include "cli/parse_problem.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "text/names.h"

namespace raceway::cli {
namespace {

std::string flag_suggestion(const CLI::App& command, const std::string& flag) {
  // Compared as keys of a file are, so that --axial_load_N and --load find --axial-load.
  const auto as_key = [](std::string text) {
    text.erase(0, text.find_first_not_of('-'));
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
  };
  std::vector<std::string> flags, keys;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) {
      flags.push_back("--" + name);
      keys.push_back(as_key(name));
    }
  const std::string key = as_key(flag);
  const auto answer = [&](std::size_t i) { return "; did you mean " + flags[i] + "?"; };
  if (const auto near = text::nearest_name(key, keys))
    return answer(
        static_cast<std::size_t>(std::find(keys.begin(), keys.end(), *near) - keys.begin()));
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (key.size() > 2 && (keys[i].starts_with(key) || key.starts_with(keys[i]))) return answer(i);
  return {};
}

}  // namespace

std::optional<FlagProblem> flag_problem(const CLI::App& command, std::span<char* const> arguments) {
  std::set<const CLI::Option*> seen;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string argument = arguments[i];
    if (argument == "--") break;
    const bool is_flag =
        argument.size() > 1 && argument[0] == '-' &&
        (argument[1] == '-' || std::isalpha(static_cast<unsigned char>(argument[1])) != 0);
    if (!is_flag) continue;
    const bool is_long = argument[1] == '-';
    const std::string flag =
        is_long ? argument.substr(0, argument.find('=')) : argument.substr(0, 2);
    const CLI::Option* const option = command.get_option_no_throw(flag);
    if (option == nullptr)
      return FlagProblem{
          flag, flag + ": no such flag" + flag_suggestion(command, is_long ? flag : argument)};
    const bool again = !seen.insert(option).second;
    if (again && option->get_multi_option_policy() != CLI::MultiOptionPolicy::TakeAll)
      return FlagProblem{flag, flag + " is given twice"};
    if (option->get_items_expected_max() == 0) continue;
    std::string value = argument.substr(flag.size());  // =VALUE, or VALUE after a short flag
    if (value.empty() && i + 1 < arguments.size() &&
        !std::string_view(arguments[i + 1]).starts_with("--"))
      value = arguments[++i];
    if (value.empty() || value == "=") return FlagProblem{flag, flag + ": its value is missing"};
  }
  return std::nullopt;
}

std::string missing_name(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0) return option->get_name();
  return {};
}

}  // namespace raceway::cli
