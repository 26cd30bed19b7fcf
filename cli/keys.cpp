#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/shared_flags.h"
#include "cli/text_table.h"
#include "files/key_tables.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

using files::ListedKey;

/// "0.1 to 300 mm", or the words that may stand there.
std::string allowed(const files::Form& form) {
  if (!form.words.empty()) return text::listed(form.choices(), "or");
  if (!std::isfinite(form.lower)) return std::string(form.unit);
  return fmt::format("{:.6g} to {:.6g}{}{}", form.lower, form.upper, form.unit.empty() ? "" : " ",
                     form.unit);
}

/// Whether every word stands in table, key or meaning.
bool tells_of(const ListedKey& one, const std::string& words) {
  const std::string whole =
      text::lower_case(fmt::format("[{}] {} {}", one.table, one.key.name, one.meaning()));
  std::istringstream in(text::lower_case(words));
  for (std::string word; in >> word;)
    if (whole.find(word) == std::string::npos) return false;
  return true;
}

void print_key(const ListedKey& one) {
  const std::string in = allowed(one.key.form);
  const std::string fallback = one.key.fallback.required ? "required"
                               : one.fallback().empty()  ? ""
                                                         : "default " + one.fallback();
  fmt::print("  {}{}{}", one.key.name, in.empty() ? "" : "  ", in);
  if (!fallback.empty()) fmt::print("{}{}", in.empty() ? "  " : "; ", fallback);
  fmt::print("\n");
  constexpr std::size_t margin = 6;
  for (const std::string& line :
       filled(one.meaning(), std::max<std::size_t>(terminal_width(), 50) - margin))
    fmt::print("{:{}}{}\n", "", margin, line);
}

int show_keys(const std::string& words, bool json) {
  std::vector<ListedKey> keys = files::model_keys();
  std::erase_if(keys, [&](const ListedKey& one) { return !tells_of(one, words); });
  if (keys.empty())
    throw text::InputError(
        fmt::format(
            "raceway keys: no key has \"{}\" in its table, name or meaning. Without words, the "
            "command lists all keys; raceway effects ID lists the parameters of an effect",
            words),
        {.key = "WORDS"});
  if (json) {
    put_document(files::model_keys_json(keys));
    return done;
  }
  std::string_view table;
  for (const ListedKey& one : keys) {
    if (one.table != table) fmt::print("{}[{}]\n", table.empty() ? "" : "\n", one.table);
    table = one.table;
    print_key(one);
  }
  return done;
}

}  // namespace

Run setup_keys(CLI::App& command) {
  auto words = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command
      .add_option("WORDS", *words,
                  "words to search for in table, name and meaning; a key must contain all of them; "
                  "default: all keys")
      ->type_name("");
  declare_json(command, *json);
  command.footer(
      "Example:\n  raceway keys conformity\n  raceway keys \"[lubricant]\"\n"
      "  raceway keys \"coolant channel\"");
  return [=] { return show_keys(*words, *json); };
}

}  // namespace raceway::cli
