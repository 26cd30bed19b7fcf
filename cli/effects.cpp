#include <fmt/core.h>

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/effects_text.h"
#include "cli/messages.h"
#include "cli/shared_flags.h"
#include "correction/catalogue.h"
#include "effects/catalogue.h"
#include "model/own_data.h"
#include "results/results.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

using effects::Description;

/// Returns true if one of the texts has these words, upper and lower case alike.
bool any_has(std::initializer_list<std::string_view> texts, const std::string& words) {
  return std::any_of(texts.begin(), texts.end(), [&](std::string_view text) {
    return text::lower_case(text).find(text::lower_case(words)) != std::string::npos;
  });
}

std::vector<Description> matching(const std::string& words) {
  std::vector<Description> found;
  for (const Description& d : effects::catalogue())
    if (any_has({d.id, d.title, d.mechanism, d.formula, d.source}, words)) found.push_back(d);
  return found;
}

std::vector<Description> forms_of(std::string_view id) {
  std::vector<Description> forms;
  for (const Description& d : effects::all_forms())
    if (d.id == id) forms.push_back(d);
  return forms;
}

[[noreturn]] void refuse_unknown(const std::string& id) {
  std::vector<std::string> ids;
  for (const Description& known : effects::catalogue()) ids.emplace_back(known.id);
  for (const correction::EffectCard& card : correction::catalogue()) ids.emplace_back(card.id);
  const std::string near = text::suggestion(id, ids);
  throw text::InputError(fmt::format("raceway effects: {}: unknown effect{}", id,
                                     near.empty() ? "; raceway effects lists them" : near),
                         {.key = "ID"});
}

/// `card`: of records over time, or null.
int explain(const std::vector<Description>& forms, const correction::EffectCard* card, bool json) {
  if (json) {
    put_document(forms.size() == 1 && !card
                     ? results::effect_json(forms[0])
                     : results::effects_json(forms, std::span(card, card ? 1 : 0)));
    return done;
  }
  for (const Description& d : forms) {
    if (&d != &forms.front()) fmt::print("\n");
    print_effect_card(d);
  }
  if (card && !forms.empty()) fmt::print("\n");
  if (card) print_effect_card(*card);
  return done;
}

std::vector<correction::EffectCard> matching_cards(const std::string& words) {
  std::vector<correction::EffectCard> found;
  for (const correction::EffectCard& card : correction::catalogue())
    if (any_has({card.id, card.title, card.form}, words)) found.push_back(card);
  return found;
}

int list(std::span<const Description> found, std::span<const correction::EffectCard> cards,
         bool json) {
  if (json) {
    put_document(results::effects_json(found, cards));
    return done;
  }
  if (!found.empty()) print_effect_list(found);
  if (!cards.empty()) print_effect_list(cards);
  fmt::print("\nraceway effects ID explains an effect.\n");
  return done;
}

int show(const std::string& id, bool json) {
  if (id.empty())
    return list(json ? effects::all_forms() : effects::catalogue(), correction::catalogue(), json);
  // Ids are unique for each subject: one may stand for a rig, a shaft and a record over time.
  const std::vector<Description> forms = forms_of(id);
  const correction::EffectCard* const card = correction::find_card(id.substr(0, id.find(':')));
  if (!forms.empty() || card) return explain(forms, card, json);
  if (const std::string own = model::own_datum_explained(id); !own.empty() && !json) {
    fmt::print("{}\n", own);
    return done;
  }
  const std::vector<Description> found = matching(id);
  const std::vector<correction::EffectCard> cards = matching_cards(id);
  if (found.empty() && cards.empty()) refuse_unknown(id);
  if (found.size() == 1 && cards.empty()) return explain(forms_of(found[0].id), nullptr, json);
  return list(found, cards, json);
}

}  // namespace

Run setup_effects(CLI::App& command) {
  auto id = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command.add_option("ID", *id, "effect to explain, or words to search for; default: all effects")
      ->type_name("");
  declare_json(command, *json);
  command.footer("Example:\n  raceway effects thermal-preload\n  raceway effects air");
  return [=] { return show(*id, *json); };
}

}  // namespace raceway::cli
