#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "cli/describe.h"
#include "cli/help.h"
#include "correction/catalogue.h"
#include "effects/catalogue.h"

namespace raceway::cli {
namespace {

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

/// What follows a flag or stands for an argument.
enum class Takes { nothing, value, file, effect, file_or_effect };

Takes takes(const CLI::Option& option) {
  if (option.get_positional()) {
    const std::string name = option.get_name();
    if (name.find("EFFECT") != name.npos) return Takes::file_or_effect;
    if (name == "ID") return Takes::effect;
    for (const std::string_view of_file : {"MODEL", "MODELS", "DATA", "FILES", "CSV"})
      if (name == of_file) return Takes::file;
    return Takes::value;
  }
  if (option.get_items_expected_max() == 0) return Takes::nothing;
  return option.get_type_name() == "FILE" ? Takes::file : Takes::value;
}

/// What the arguments of a command that are no flags may be.
Takes arguments_of(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) return takes(*option);
  return Takes::nothing;
}

template <typename List, typename Name>
std::string words_of(const List& list, const Name& name) {
  std::string all;
  for (const auto& one : list) all += (all.empty() ? "" : " ") + std::string(name(one));
  return all;
}

std::string ids_on_bearings() {
  return words_of(effects::catalogue(), [](const auto& effect) { return effect.id; });
}
/// Of models with [correction].
std::string ids_over_time() {
  return words_of(correction::catalogue(), [](const auto& effect) { return effect.id; });
}

std::string command_names(const CLI::App& app) {
  return words_of(listed_commands(app), [](const auto* command) { return command->get_name(); });
}

/// One line of a help, with the signs that a bracket of _arguments would end at.
std::string zsh_text(std::string_view help) {
  std::string text;
  for (const char c : help) {
    if (c == '\'')
      text += "'\\''";
    else if (c == '\n')
      text += ' ';
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      text += {'\\', c};
    else
      text += c;
  }
  return text;
}

std::string zsh_action(Takes what) {
  if (what == Takes::file) return "_files";
  if (what == Takes::effect) return fmt::format("({} {})", ids_on_bearings(), ids_over_time());
  return what == Takes::file_or_effect ? "_raceway_files_and_effects" : " ";
}

std::string zsh_flag(const CLI::Option& option) {
  std::string lines;
  const Takes what = takes(option);
  const std::string value =
      what == Takes::nothing ? "" : fmt::format(":{}:{}", option.get_type_name(), zsh_action(what));
  for (const std::string& name : names_of(option))
    lines +=
        fmt::format("        '{}[{}]{}' \\\n", name, zsh_text(option.get_description()), value);
  return lines;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string cases;
  for (const CLI::App* command : listed_commands(app)) {
    std::string flags, of_file, of_value;
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : names_of(*option)) {
        flags += name + " ";
        if (takes(*option) == Takes::file) of_file += name + " ";
        if (takes(*option) == Takes::value) of_value += name + " ";
      }
    const Takes arguments = arguments_of(*command);
    const bool files = arguments == Takes::file || arguments == Takes::file_or_effect;
    const bool effects = arguments == Takes::effect || arguments == Takes::file_or_effect;
    cases += fmt::format("    {}) flags='{}' of_file='{}' of_value='{}' files={} words={} ;;\n",
                         command->get_name(), flags, of_file, of_value, files ? 1 : 0,
                         !effects                     ? "''"
                         : arguments == Takes::effect ? "$on_bearings' '$over_time"
                                                      : "$(_raceway_effects)");
  }
  return fmt::format(R"(# bash completion of raceway; made by: raceway describe bash
# Effects for the first model of the command line; all effects if it cannot be read.
_raceway_effects() {{
  local model=${{COMP_WORDS[2]}}
  if [[ -f $model ]] && grep -q '^ *\[*correction' -- "$model"; then
    printf '%s' "$over_time"
  elif [[ -f $model ]]; then
    printf '%s' "$on_bearings"
  else
    printf '%s' "$on_bearings $over_time"
  fi
}}
_raceway() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
  local flags='' of_file='' of_value='' files=0 words=''
  local on_bearings='{2}'
  local over_time='{3}'
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{0} help --help --version' -- "$word")
    return
  fi
  case ${{COMP_WORDS[1]}} in
    help) words='{0}' ;;
{1}  esac
  if [[ " $of_value " == *" $before "* ]]; then return; fi
  if [[ " $of_file " == *" $before "* ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$flags" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word"; ((files)) && compgen -f -- "$word")
  fi
}}
complete -o filenames -F _raceway raceway
)",
                     command_names(app), cases, ids_on_bearings(), ids_over_time());
}

std::string zsh_completion(const CLI::App& app) {
  std::string list, cases;
  for (const CLI::App* command : listed_commands(app)) {
    list += fmt::format("    '{}:{}'\n", command->get_name(), zsh_text(command->get_description()));
    cases += fmt::format("    {})\n      _arguments \\\n", command->get_name());
    for (const CLI::Option* option : command->get_options()) cases += zsh_flag(*option);
    cases += fmt::format("        '*: :{}' ;;\n", zsh_action(arguments_of(*command)));
  }
  return fmt::format(R"(#compdef raceway
# zsh completion of raceway; made by: raceway describe zsh
# Effects for the first model of the command line; all effects if it cannot be read.
_raceway_files_and_effects() {{
  local on_bearings='{0}'
  local over_time='{1}'
  local effects="$on_bearings $over_time"
  if [[ -f $words[2] ]]; then
    grep -q '^ *\[*correction' -- $words[2] && effects=$over_time || effects=$on_bearings
  fi
  _alternative 'files:file:_files' 'effects:effect:('$effects')'
}}
_raceway() {{
  local -a commands=(
{2}    'help:The flags of a command'
  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  shift words
  ((CURRENT--))
  case $words[1] in
{3}    help) _describe command commands ;;
  esac
}}
_raceway "$@"
)",
                     ids_on_bearings(), ids_over_time(), list, cases);
}

}  // namespace raceway::cli
