#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "io/catalogue_defaults.h"
#include "record/units.h"

// Last: see io/toml_text.h.
#include "io/contact_section.h"
#include "io/friction_section.h"

namespace raceway::io {
namespace {

using friction::F1Load;
using friction::FrictionLaw;
using friction::Supply;

constexpr Key viscosity_40C{"viscosity_40C_mm2_s", "mm2/s", 1, 1e5};
constexpr Key viscosity_100C{"viscosity_100C_mm2_s", "mm2/s", 0.5, 1e5};

constexpr std::string_view f1_load = "f1_load";

bool has(FrictionLaw law, std::string_view key) {
  const auto numbers = friction::parameters(law);
  if (std::any_of(numbers.begin(), numbers.end(), [&](const friction::Parameter& p) {
        return p.name == key && !friction::of_the_lubricant(p);
      }))
    return true;
  if (law == FrictionLaw::palmgren) return key == f1_load;
  const Names of_contact = contact_keys("friction");
  return law == FrictionLaw::contact &&
         std::find(of_contact.begin(), of_contact.end(), key) != of_contact.end();
}

std::string belongs_to_other(std::string_view key, const toml::node& value, FrictionLaw other,
                             FrictionLaw law) {
  return fmt::format("{} = {}: belongs to law = \"{}\", but the law is \"{}\"", key, shown(value),
                     friction::name(other), friction::name(law));
}

void refuse_values_of_other_law(const Section& s, FrictionLaw law) {
  if (!s.given()) return;
  for (const auto& [key, node] : *s.table())
    for (const FrictionLaw other : friction::all_friction_laws)
      if (!has(law, key.str()) && has(other, key.str()))
        s.fail(key.str(), belongs_to_other(key.str(), node, other, law));
}

double catalogue_value(const friction::Parameter& p) {
  return p.name == "f0"  ? catalogue_f0
         : p.name == "z" ? catalogue_z
         : p.name == "y" ? catalogue_y
                         : p.initial;
}

}  // namespace

LubricantOfFile read_lubricant(const ModelTables& tables) {
  const Section s =
      tables.required_section("lubricant", "viscosity_40C_mm2_s and viscosity_100C_mm2_s");
  Names known{"viscosity_40C_mm2_s", "viscosity_100C_mm2_s", "supply"};
  for (std::string& key : contact_keys("lubricant")) known.push_back(std::move(key));
  s.allow_only(known);
  Names supplies;
  for (const Supply supply : {Supply::oil_air, Supply::grease, Supply::jet, Supply::bath})
    supplies.emplace_back(friction::name(supply));
  const auto supply = s.choice("supply", supplies);
  try {
    return {.lubricant = {s.required(viscosity_40C) * mm2_per_s,
                          s.required(viscosity_100C) * mm2_per_s},
            .supply = supply ? friction::find_supply(*supply) : std::nullopt};
  } catch (const std::invalid_argument& error) {
    // "viscosity_40C" and "viscosity_100C" are the libraries' names of the two keys.
    s.fail(error, known);
  }
}

LawOfFile read_friction(ModelTables& tables, bool from_catalogue, const Names& further) {
  const Section s = from_catalogue
                        ? tables.section("friction")
                        : tables.required_section("friction", "the base law and its factors");
  Names laws;
  for (const FrictionLaw law : friction::all_friction_laws) laws.emplace_back(friction::name(law));
  LawOfFile result{.law = *friction::find_friction_law(tables.choice_or(s, "law", laws, laws[0])),
                   .values = {}};
  refuse_values_of_other_law(s, result.law);
  Names known{"law"};
  for (const friction::Parameter& p : friction::parameters(result.law))
    if (!friction::of_the_lubricant(p)) known.emplace_back(p.name);
  if (result.law == FrictionLaw::palmgren) known.emplace_back(f1_load);
  if (result.law == FrictionLaw::contact)
    for (std::string& key : contact_keys("friction")) known.push_back(std::move(key));
  known.insert(known.end(), further.begin(), further.end());
  s.allow_only(known);
  if (result.law == FrictionLaw::palmgren) {
    const Names loads{std::string(friction::name(F1Load::P0)),
                      std::string(friction::name(F1Load::F_b))};
    result.f1_load =
        tables.choice_or(s, f1_load, loads, loads[0]) == loads[0] ? F1Load::P0 : F1Load::F_b;
  }
  // The factors of the SKF law are published constants, those of the contacts are 1; those of
  // Palmgren depend on the bearing, and only a catalogue's user may leave them out.
  const bool required = result.law == FrictionLaw::palmgren && !from_catalogue;
  for (const friction::Parameter& p : friction::parameters(result.law)) {
    const Key key{p.name, p.unit == "1" ? "" : p.unit, p.lower, p.upper};
    if (friction::of_the_lubricant(p))
      result.values.push_back(
          tables.number_or(tables.section("lubricant"), key, default_of_lubricant(tables)));
    else
      result.values.push_back(required ? s.required(key)
                                       : tables.number_or(s, key, catalogue_value(p)));
  }
  return result;
}

Names missing_keys_of_friction(const ModelTables& tables) {
  Names missing = tables.section("lubricant").lacking({viscosity_40C, viscosity_100C});
  const Section s = tables.section("friction");
  const Section bearing = tables.section("bearing");
  if (bearing.find("catalogue") ||
      s.text("law").value_or("palmgren") != friction::name(FrictionLaw::palmgren))
    return missing;
  for (const std::string& one : bearing.lacking({static_load_rating})) missing.push_back(one);
  std::vector<Key> factors;
  for (const friction::Parameter& p : friction::parameters(FrictionLaw::palmgren))
    factors.push_back({p.name, p.unit == "1" ? "" : p.unit, p.lower, p.upper});
  for (const std::string& one : s.lacking(factors)) missing.push_back(one);
  return missing;
}

void require_data(FrictionLaw law, const bearing::Bearing& bearing, const Section& s) {
  if (law == FrictionLaw::palmgren && std::isnan(bearing.geometry().static_load_rating))
    s.fail_missing(static_load_rating, ", which the friction law palmgren needs");
  try {
    friction::require_data(law, bearing);
  } catch (const std::invalid_argument& error) {
    s.fail(error, {"static_load_rating_N", "contact_angle_deg"});
  }
}

}  // namespace raceway::io
