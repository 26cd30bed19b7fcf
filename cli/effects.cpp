#include <fmt/core.h>

#include <string>

#include "cli/commands.h"
#include "cli/effects_text.h"
#include "cli/messages.h"
#include "cli/shared_flags.h"
#include "session/catalogues.h"

namespace raceway::cli {
namespace {

void print(const session::FoundEffects& found) {
  if (!found.own_datum.empty()) return fmt::print("{}\n", found.own_datum);
  if (found.is_list) {
    if (!found.effects.empty()) print_effect_list(found.effects);
    if (!found.of_records.empty()) print_effect_list(found.of_records);
    return fmt::print("\nraceway effects ID explains an effect.\n");
  }
  for (const effects::Description& d : found.effects) {
    if (&d != &found.effects.front()) fmt::print("\n");
    print_effect_card(d);
  }
  if (!found.of_records.empty() && !found.effects.empty()) fmt::print("\n");
  for (const correction::EffectCard& card : found.of_records) print_effect_card(card);
}

int run(const std::string& asked, bool json) {
  const session::FoundEffects found = session::find_effects(asked);
  if (json)
    put_document(found.json());
  else
    print(found);
  return done;
}

}  // namespace

Run setup_effects(CLI::App& command) {
  auto id = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command.add_option("ID", *id, "effect to explain, or words to search for; default: all effects")
      ->type_name("");
  declare_json(command, *json);
  command.footer("Example:\n  raceway effects thermal-preload\n  raceway effects air");
  return [=] { return run(*id, *json); };
}

}  // namespace raceway::cli
