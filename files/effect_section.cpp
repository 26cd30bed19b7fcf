#include <algorithm>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "text/csv.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/effect_section.h"
#include "files/detail/formula_section.h"

namespace raceway::files {
namespace {

constexpr Key effect_id_keys[]{
    {"id", a_text, is_required,
     "id of an effect in the catalogue, which raceway effects lists, or a new id for an effect "
     "with a formula. The parameters of the effect are further keys of this table"}};
constexpr Key own_effect_keys[]{
    {"torque_Nmm", a_text, unset,
     "formula of your own effect: torque in N mm as a function of columns and of the parameters of "
     "the effect"},
    {"title", a_text, unset, "title of your own effect in messages"},
};

using effects::Description;
using effects::UserMadeEffect;

/// What a formula may use beside its parameters.
Names variables() {
  Names names;
  for (const auto& v : effects::Formula::variables()) names.emplace_back(v.name);
  return names;
}

Names known_to(const UserMadeEffect& effect) {
  Names known = variables();
  for (const auto& p : effect.parameters) known.push_back(p.name);
  return known;
}

UserMadeEffect::Number number_of(FormulaNumber n) {
  return {std::move(n.name), std::move(n.unit), n.value, n.lower, n.upper};
}

/// An effect of the user's own: a formula and its parameters.
effects::Effect read_user_made(const Section& table, const std::string& id) {
  const Section s = table.part({effect_id_keys, own_effect_keys});
  UserMadeEffect effect{.id = id,
                        .title = s.text("title").value_or(""),
                        .torque_Nmm = *s.text("torque_Nmm"),
                        .parameters = {}};
  // It heads a column of tables, in files and in spreadsheets.
  if (id.empty() || id.find_first_of(" .\t\n,;\"'") != id.npos ||
      std::string_view("=+-@").find(id.front()) != std::string_view::npos)
    s.fail("id", fmt::format("id = {}: must be a name without blanks, dots, commas, semicolons and "
                             "quotes, and must not begin with =, +, - or @",
                             text::quoted(id)));
  for (const auto& [key, node] : *s.table()) {
    const std::string name(key.str());
    if (name != "id" && name != "title" && name != "torque_Nmm")
      effect.parameters.push_back(number_of(read_formula_number(s, id, name, node, variables())));
  }
  try {
    return effects::make_effect(effect);
  } catch (const effects::FormulaError& error) {
    fail_formula(s, "torque_Nmm", id, effect.torque_Nmm, error, known_to(effect));
  }
}

class EffectReader {
 public:
  EffectReader(ModelTables& tables, const model::Shaft* shaft, bool spindle)
      : tables_(tables),
        shaft_(shaft),
        form_(spindle ? effects::Form::spindle
              : shaft ? effects::Form::shaft
                      : effects::Form::rig) {
    for (const Description& d : effects::catalogue(form_))
      if (d.belongs_to(form_)) ids_.emplace_back(d.id);
  }

  std::vector<effects::Effect> read() {
    if (const toml::array* const list = tables_.root()["effect"].as_array())
      for (const toml::node& node : *list) {
        const Section s =
            Section(tables_.source(), "effect", node.as_table()).part({effect_id_keys});
        const auto id = s.text("id");
        if (!id)
          throw text::InputError(
              fmt::format("{}: [[effect]] id is missing: give the id of an effect of the "
                          "catalogue, or a new id with a formula torque_Nmm; the catalogue has {}",
                          s.place(), text::listed(ids_)),
              s.at("id"));
        const Description* const found = find(s, *id);
        effects_.push_back(found ? from_catalogue(s, *found) : read_user_made(s, *id));
      }
    return std::move(effects_);
  }

 private:
  /// Why the model cannot have it.
  std::string refusal(const Description& d) const {
    if (d.of_spindles_alone())
      return "the effect acts on a spindle, but this model has no [shaft] and [housing]";
    if (form_ == effects::Form::spindle)
      return d.condition && d.follows_heat
                 ? "not possible, because the calculated temperatures of a spindle already include "
                   "this effect"
                 : "the effect acts on a bearing on a rig, but this is the model of a spindle";
    return shaft_ ? "the effect acts on a bearing on a rig, but this model has an [arrangement]"
                  : "the effect acts on the displacement of a shaft, but this model has no "
                    "[arrangement]";
  }

  /// Null for one of the user's own.
  const Description* find(const Section& s, const std::string& id) const {
    const auto fail = [&](const std::string& why) {
      s.fail("id", fmt::format("id = \"{}\": {}", id, why));
    };
    const Description* const found = effects::find(id, form_);
    if (found && !found->belongs_to(form_)) fail(refusal(*found));
    if (!found && !s.find("torque_Nmm")) {
      const std::string near = text::suggestion(id, ids_);
      fail(fmt::format("unknown effect{}; for an effect of your own, give a formula torque_Nmm",
                       near.empty() ? "; the catalogue has " + text::listed(ids_) : near));
    }
    if (found && shaft_ && shaft_->arrangement.design().rear.empty())
      for (const effects::Need need : found->needs)
        if (need == effects::Need::opposed_sets)
          fail(fmt::format("the effect needs {}", effects::text(need)));
    for (const effects::Effect& before : effects_)
      if (before.description->id == id) fail("two tables have this effect; remove one");
    return found;
  }

  effects::Effect from_catalogue(const Section& table, const Description& description) {
    // A text is a formula; a number is the parameter that torque-offset calls so.
    if (const toml::node* const formula = table.find("torque_Nmm"); formula && formula->is_string())
      table.fail(
          "torque_Nmm",
          fmt::format(
              "torque_Nmm: {} is the id of an effect in the catalogue; give your effect another id",
              description.id));
    std::vector<Key> numbers;
    for (const effects::Parameter& p : description.parameters)
      numbers.push_back({p.name, between(p), p.initial, description.title});
    const Section s = table.with({effect_id_keys, numbers});
    effects::Effect effect;
    effect.description = &description;
    for (const effects::Parameter& p : description.parameters) {
      const auto value = s.number(p.name);
      effect.values.push_back(value.value_or(p.initial));
      if (!value)
        tables_.note_default(fmt::format("effect[{}]", effects_.size()), p.name,
                             fmt::format("{:.10g}", p.initial),
                             fmt::format("default of {}", description.id));
    }
    return effect;
  }

  ModelTables& tables_;
  const model::Shaft* shaft_;
  effects::Form form_;
  Names ids_;
  std::vector<effects::Effect> effects_;
};

}  // namespace

std::vector<KeyTable> effect_tables() {
  return {{"effect", effect_id_keys}, {"effect", own_effect_keys}};
}

std::vector<effects::Effect> read_effects(ModelTables& tables, const model::Shaft* shaft,
                                          bool spindle) {
  return EffectReader(tables, shaft, spindle).read();
}

}  // namespace raceway::files
