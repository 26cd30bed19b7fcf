#include <algorithm>
#include <cmath>
#include <limits>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "io/csv.h"

// Last: see io/toml_text.h.
#include "io/effect_section.h"

namespace raceway::io {
namespace {

using effects::Description;
using effects::Effect;
using effects::UserMadeEffect;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A name that muParser takes for a variable.
bool valid_name(std::string_view name) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !name.empty() && letter(name[0]) && std::all_of(name.begin(), name.end(), [&](char c) {
    return letter(c) || (c >= '0' && c <= '9');
  });
}

/// File, line and column of what is wrong with a formula, and the formula with a mark under it.
[[noreturn]] void wrong_formula(const Section& s, const UserMadeEffect& effect,
                                const effects::FormulaError& error) {
  std::string hint;
  if (!error.unknown_name.empty()) {
    Names known;
    for (const auto& v : effects::Formula::variables()) known.emplace_back(v.name);
    for (const auto& p : effect.parameters) known.push_back(p.name);
    hint = suggestion(error.unknown_name, known);
    if (hint.empty()) {
      if (valid_name(error.unknown_name))
        hint = fmt::format("; if it is a parameter, give {} = {{value = 1.0, unit = \"N mm\"}}",
                           error.unknown_name);
      hint += "; a formula knows " + listed(known);
    }
  }
  const toml::source_position at = s.find("torque_Nmm")->source().begin;
  // Exact for a formula in plain quotes, which has no escapes.
  throw InputError(fmt::format("{}:{}:{}: effect {}: torque_Nmm: {}{}\n  {}\n  {:>{}}", s.source(),
                               at.line, at.column + 1 + error.position, effect.id, error.what(),
                               hint, effect.torque_Nmm, "^", error.position + 1),
                   s.at("torque_Nmm"));
}

/// A part of a unit that is another one than that of the files, as m or kN; empty where there is
/// none. A unit of a formula's parameter is a label: nothing is converted by it.
std::string unit_of_no_file(std::string_view unit) {
  static const Names others{"Nm", "mNm", "kNm", "Ncm",  "uNm", "kN",  "MN", "m",
                            "cm", "rad", "Hz",  "krpm", "F",   "lbf", "in", "inch"};
  std::string word;
  for (std::size_t at = 0; at <= unit.size(); ++at) {
    const char c = at < unit.size() ? unit[at] : ' ';
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) {
      word += c;
      continue;
    }
    if (std::find(others.begin(), others.end(), word) != others.end()) return word;
    word.clear();
  }
  return {};
}

/// `c = { value = 0.0, unit = "N mm", lower = 0.0 }` or short `c = 0.0`.
UserMadeEffect::Number read_number(const Section& s, const std::string& id, const std::string& name,
                                   const toml::node& node) {
  const auto variables = effects::Formula::variables();
  if (std::any_of(variables.begin(), variables.end(),
                  [&](const effects::Formula::Variable& v) { return v.name == name; }))
    s.fail(name, fmt::format("{}: a variable has this name; take another", name));
  if (!valid_name(name))
    s.fail(name, fmt::format("{}: must be letters, digits and _, not a digit first", name));
  UserMadeEffect::Number number{.name = name, .unit = "1"};
  if (!node.is_table()) {
    number.value = *s.number({name, "", -infinity, infinity});
    return number;
  }
  const Section t(s.source(), fmt::format("effect {}, {}", id, name), node.as_table());
  t.allow_only({"value", "unit", "lower", "upper"});
  number.unit = t.text("unit").value_or("1");
  if (const std::string other = unit_of_no_file(number.unit); !other.empty())
    t.fail("unit",
           fmt::format("{}: unit = \"{}\": a formula is in the units of the files, N mm, N, "
                       "rpm, C, mm2/s, mm, s; {} is none of them, and no value is "
                       "converted: give it in these",
                       name, number.unit, other));
  if (const auto lower = t.number({"lower", number.unit, -infinity, infinity}))
    number.lower = *lower;
  if (const auto upper = t.number({"upper", number.unit, -infinity, infinity}))
    number.upper = *upper;
  const double from = std::isnan(number.lower) ? -infinity : number.lower;
  const double to = std::isnan(number.upper) ? infinity : number.upper;
  if (!(from < to))
    t.fail("upper", fmt::format("{}: upper = {} must be above lower = {}", name, to, from));
  number.value = t.required({"value", number.unit, from, to});
  return number;
}

/// An effect of the user's own: a formula and its parameters.
Effect read_user_made(const Section& s, const std::string& id) {
  UserMadeEffect effect{.id = id,
                        .title = s.text("title").value_or(""),
                        .torque_Nmm = *s.text("torque_Nmm"),
                        .parameters = {}};
  // It heads a column of tables, in files and in spreadsheets.
  if (id.empty() || id.find_first_of(" .\t\n,;\"'") != id.npos ||
      std::string_view("=+-@").find(id.front()) != std::string_view::npos)
    s.fail("id", fmt::format("id = {}: must be a name without blanks, dots, commas, semicolons and "
                             "quotes, and not begin with =, +, - or @",
                             io::quoted(id)));
  for (const auto& [key, node] : *s.table()) {
    const std::string name(key.str());
    if (name != "id" && name != "title" && name != "torque_Nmm")
      effect.parameters.push_back(read_number(s, id, name, node));
  }
  try {
    return effects::make_effect(effect);
  } catch (const effects::FormulaError& error) {
    wrong_formula(s, effect, error);
  }
}

class EffectReader {
 public:
  EffectReader(ModelTables& tables, const model::Shaft* shaft)
      : tables_(tables), shaft_(shaft), form_(shaft ? effects::Form::shaft : effects::Form::rig) {
    for (const Description& d : effects::catalogue(form_))
      if (d.belongs_to(form_)) ids_.emplace_back(d.id);
  }

  std::vector<Effect> read() {
    if (const toml::array* const list = tables_.root()["effect"].as_array())
      for (const toml::node& node : *list) {
        const Section s(tables_.source(), "effect", node.as_table());
        const auto id = s.text("id");
        if (!id)
          throw InputError(fmt::format("{}: [[effect]] has no id; the catalogue has {}", s.place(),
                                       listed(ids_)),
                           s.at("id"));
        const Description* const found = find(s, *id);
        effects_.push_back(found ? from_catalogue(s, *found) : read_user_made(s, *id));
      }
    return std::move(effects_);
  }

 private:
  /// Null for one of the user's own.
  const Description* find(const Section& s, const std::string& id) const {
    const auto fail = [&](const std::string& why) {
      s.fail("id", fmt::format("id = \"{}\": {}", id, why));
    };
    const Description* const found = effects::find(id, form_);
    if (found && !found->belongs_to(form_))
      fail(shaft_ ? "acts on a bearing on a rig, but this model is of a shaft, with an "
                    "[arrangement]"
                  : "acts on the displacement of a shaft, but this model has no [arrangement]");
    if (!found && !s.find("torque_Nmm")) {
      const std::string near = suggestion(id, ids_);
      fail(fmt::format("unknown effect{}; one of your own has a formula, torque_Nmm",
                       near.empty() ? "; the catalogue has " + listed(ids_) : near));
    }
    if (found && shaft_ && shaft_->arrangement.design().rear.empty())
      for (const effects::Need need : found->needs)
        if (need == effects::Need::opposed_sets) fail(fmt::format("needs {}", effects::text(need)));
    for (const Effect& before : effects_)
      if (before.description->id == id) fail("this effect is listed twice");
    return found;
  }

  Effect from_catalogue(const Section& s, const Description& description) {
    // A text is a formula; a number is the parameter that torque-offset calls so.
    if (const toml::node* const formula = s.find("torque_Nmm"); formula && formula->is_string())
      s.fail("torque_Nmm",
             fmt::format("torque_Nmm: {} is an effect of the catalogue; give yours another id",
                         description.id));
    Names known{"id"};
    for (const effects::Parameter& p : description.parameters) known.emplace_back(p.name);
    s.allow_only(known);
    Effect effect;
    effect.description = &description;
    for (const effects::Parameter& p : description.parameters) {
      const auto value = s.number({p.name, p.unit == "1" ? "" : p.unit, p.lower, p.upper});
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
  std::vector<Effect> effects_;
};

}  // namespace

std::vector<Effect> read_effects(ModelTables& tables, const model::Shaft* shaft) {
  return EffectReader(tables, shaft).read();
}

}  // namespace raceway::io
