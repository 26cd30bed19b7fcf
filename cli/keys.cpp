#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/text_table.h"
#include "io/error.h"
#include "io/model_keys.h"
#include "io/names.h"

namespace raceway::cli {
namespace {

using io::ModelKey;

/// "0.1 to 300 mm", or the words that may stand there.
std::string allowed(const ModelKey& key) {
  if (!key.choices.empty()) return io::listed(key.choices, "or");
  if (!std::isfinite(key.lower) || !std::isfinite(key.upper)) return key.unit;
  return fmt::format("{:.6g} to {:.6g}{}", key.lower, key.upper,
                     key.unit.empty() || key.unit == "1" ? "" : " " + key.unit);
}

std::string default_of(const ModelKey& key) {
  constexpr std::string_view said = "default: ";
  return key.required                     ? "required"
         : key.fallback.starts_with(said) ? key.fallback.substr(said.size())
                                          : key.fallback;
}

/// Whether every word stands in table, key or meaning.
bool tells_of(const ModelKey& key, const std::string& words) {
  const std::string whole =
      io::lower_case(fmt::format("[{}] {} {}", key.table, key.name, key.meaning));
  std::istringstream in(io::lower_case(words));
  for (std::string word; in >> word;)
    if (whole.find(word) == std::string::npos) return false;
  return true;
}

void print_key(const ModelKey& key) {
  const std::string in = allowed(key), fallback = default_of(key);
  fmt::print("  {}", key.name);
  if (!in.empty()) fmt::print("  {}", in);
  if (!fallback.empty())
    fmt::print("{}{}{}", in.empty() ? "  " : "; ", key.required ? "" : "default ", fallback);
  fmt::print("\n");
  constexpr std::size_t margin = 6;
  for (const std::string& line :
       filled(key.meaning, std::max<std::size_t>(terminal_width(), 50) - margin))
    fmt::print("{:{}}{}\n", "", margin, line);
}

int show_keys(const std::string& words, bool json) {
  std::vector<ModelKey> keys = io::model_keys();
  std::erase_if(keys, [&](const ModelKey& key) { return !tells_of(key, words); });
  if (keys.empty())
    throw io::InputError(
        fmt::format("raceway keys: no key has \"{}\" in its table, name or meaning; without words "
                    "all are listed, numbers of effects by raceway effects ID",
                    words),
        {.key = "WORDS"});
  if (json) {
    put_document(io::model_keys_json(keys));
    return done;
  }
  std::string table;
  for (const ModelKey& key : keys) {
    if (key.table != table) fmt::print("{}[{}]\n", table.empty() ? "" : "\n", key.table);
    table = key.table;
    print_key(key);
  }
  return done;
}

}  // namespace

Run setup_keys(CLI::App& command) {
  auto words = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command
      .add_option("WORDS", *words, "which all stand in table, name or meaning; without, all keys")
      ->type_name("");
  command.add_flag("--json", *json, "one JSON document instead of text");
  command.footer(
      "Example:\n  raceway keys conformity\n  raceway keys \"[lubricant]\"\n"
      "  raceway keys \"coolant channel\"");
  return [=] { return show_keys(*words, *json); };
}

}  // namespace raceway::cli
