#include "session/catalogues.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <span>

#include "effects/catalogue.h"
#include "files/designation.h"
#include "model/own_data.h"
#include "record/units.h"
#include "results/results.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::session {
namespace {

using correction::EffectCard;
using effects::Description;

/// Upper and lower case are alike.
bool any_has(std::initializer_list<std::string_view> texts, const std::string& words) {
  return std::any_of(texts.begin(), texts.end(), [&](std::string_view text) {
    return text::lower_case(text).find(text::lower_case(words)) != std::string::npos;
  });
}

[[noreturn]] void refuse_unknown(const std::string& id) {
  std::vector<std::string> ids;
  for (const Description& known : effects::catalogue()) ids.emplace_back(known.id);
  for (const EffectCard& card : correction::catalogue()) ids.emplace_back(card.id);
  const std::string near = text::suggestion(id, ids);
  throw text::InputError(fmt::format("raceway effects: {}: unknown effect{}", id,
                                     near.empty() ? "; raceway effects lists all effects" : near),
                         {.key = "ID"});
}

template <typename Entry, typename Takes>
std::vector<Entry> chosen(std::span<const Entry> all, const Takes& takes) {
  std::vector<Entry> list;
  std::copy_if(all.begin(), all.end(), std::back_inserter(list), takes);
  return list;
}

/// Bearings of the size that a designation has which no catalogue lists.
std::vector<files::CatalogueBearing> of_same_size(Messages& messages,
                                                  std::span<const files::CatalogueBearing> rows,
                                                  const std::string& designation) {
  files::require_angular_contact(designation);
  const std::string size = files::read_designation(designation).size();
  auto same = chosen(rows, [&](const files::CatalogueBearing& row) {
    return !size.empty() && files::read_designation(row.designation).size() == size;
  });
  if (!same.empty())
    messages.say(record::note::assumed(
        fmt::format("{0} is not in the catalogue. These bearings have the same size; raceway new "
                    "\"{0}\" writes a model with estimated data",
                    designation)));
  return same;
}

}  // namespace

std::string FoundEffects::json() const {
  if (!own_datum.empty()) throw text::InputError(own_datum, {.key = "ID"});
  return is_list || effects.size() != 1 || !of_records.empty()
             ? results::effects_json(effects, of_records)
             : results::effect_json(effects.front());
}

FoundEffects find_effects(const std::string& asked) {
  const std::string plain = asked.substr(0, asked.find(':'));  // without the name of a channel
  // Ids are unique for each subject: one may stand for a rig, a shaft and a record over time.
  FoundEffects found{
      .effects = chosen(effects::all_forms(),
                        [&](const Description& d) { return asked.empty() || d.id == asked; }),
      .of_records = chosen(correction::catalogue(),
                           [&](const EffectCard& c) { return asked.empty() || c.id == plain; })};
  found.is_list = asked.empty();
  if (!found.effects.empty() || !found.of_records.empty()) return found;
  found = {.own_datum = model::own_datum_explained(asked)};
  if (!found.own_datum.empty()) return found;
  found.effects = chosen(effects::catalogue(), [&](const Description& d) {
    return any_has({d.id, d.title, d.mechanism, d.formula, d.source}, asked);
  });
  found.of_records = chosen(correction::catalogue(), [&](const EffectCard& c) {
    return any_has({c.id, c.title, c.form}, asked);
  });
  if (found.effects.empty() && found.of_records.empty()) refuse_unknown(asked);
  if (found.effects.size() == 1 && found.of_records.empty())
    return find_effects(std::string(found.effects[0].id));
  return found;
}

std::vector<files::CatalogueBearing> find_bearings(Messages& messages, const std::string& name,
                                                   double bore, double outer_diameter) {
  // As printed: to a tenth of a millimetre.
  const auto is_other = [](double wanted, double size) {
    return std::abs(wanted - size) >= 0.05 * mm;  // false for NaN
  };
  const auto all = files::read_catalogues();
  auto rows = files::matching_bearings(all, name);
  if (rows.empty()) rows = of_same_size(messages, all, name);
  std::erase_if(rows, [&](const files::CatalogueBearing& r) {
    return is_other(bore, r.geometry.bore) || is_other(outer_diameter, r.geometry.outer_diameter);
  });
  if (rows.empty())
    throw text::InputError(
        fmt::format(
            "raceway bearings: no bearing has \"{}\" in its name{}; {}without a filter, the "
            "command lists all bearings",
            name, std::isnan(bore) && std::isnan(outer_diameter) ? "" : " and this size",
            files::read_designation(name).boundary()
                ? fmt::format("raceway new \"{}\" writes a model with estimated data; ", name)
                : ""),
        {.key = "FILTER"});
  return rows;
}

}  // namespace raceway::session
