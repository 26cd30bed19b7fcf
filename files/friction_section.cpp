#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "files/catalogue_defaults.h"
#include "files/friction_table.h"
#include "friction/roller_friction.h"
#include "record/channel.h"
#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/contact_section.h"
#include "files/detail/friction_section.h"
#include "files/detail/roller_section.h"

namespace raceway::files {
namespace {

const std::string words_of_supply =
    names_as_words(std::array{friction::Supply::oil_air, friction::Supply::grease,
                              friction::Supply::jet, friction::Supply::bath});
const Key lubricant_keys[]{
    {"viscosity_40C_mm2_s", between(1, 1e5, "mm2/s"), is_required,
     "kinematic viscosity of the oil at 40 C (for a grease: of its base oil); raceway converts to "
     "other temperatures by ASTM D341"},
    {"viscosity_100C_mm2_s", between(0.5, 1e5, "mm2/s"), is_required,
     "kinematic viscosity at 100 C, below the viscosity at 40 C"},
    {"supply", one_of(words_of_supply),
     "none: the law contact assumes little oil at the contact inlets",
     "lubricant supply; diagnose does not test effects that need another supply. With bath, the "
     "law contact assumes flooded contact inlets"},
};

using friction::F1Load;
using friction::FrictionLaw;

/// A number of a law, whose card says what it may be.
Key number_of(FrictionLaw law, std::string_view name, std::string_view meaning) {
  const auto numbers = friction::parameters(law);
  const friction::Parameter& card = *std::find_if(
      numbers.begin(), numbers.end(), [&](const friction::Parameter& p) { return p.name == name; });
  const double usual = friction::of_rollers(law) ? card.initial
                       : name == "f0"            ? catalogue_f0
                       : name == "z"             ? catalogue_z
                       : name == "y"             ? catalogue_y
                                                 : card.initial;
  return {card.name, between(card), usual, meaning};
}

const std::string words_of_law = names_as_words(friction::all_friction_laws);
const std::string words_of_load = names_as_words(std::array{F1Load::P0, F1Load::F_b});
const Key law_keys[]{
    {"law", one_of(words_of_law), "palmgren", "base law of friction"},
    {"file", a_text, unset,
     "CSV of a friction table, measured or written by raceway table: columns speed_rpm, "
     "axial_load_N, radial_load_N, temperature_C, friction_torque_Nmm and, for the error band, "
     "std_Nmm or friction_torque_band_Nmm. Required by the law table; with another law, diagnose "
     "tests the table"},
};
const Key palmgren_keys[]{
    number_of(FrictionLaw::palmgren, "f0",
              "factor of the viscous moment, depends on the lubrication; required without the key "
              "catalogue"),
    number_of(FrictionLaw::palmgren, "z",
              "factor of the load moment, depends on the bearing type; required without the key "
              "catalogue"),
    number_of(FrictionLaw::palmgren, "y",
              "exponent y in the factor f1 = z (F/C0)^y of the load moment; required without the "
              "key catalogue"),
    {"f1_load", one_of(words_of_load), "P0",
     "load F in the factor f1 = z (F/C0)^y of the load moment f1 F_b d_m: P0 (static equivalent "
     "load), or F_b (the load in the load moment, calculated from axial and radial load)"},
};
const Key powers_keys[]{
    number_of(FrictionLaw::powers, "viscous_exponent",
              "exponent of viscosity times speed in the viscous moment"),
    number_of(FrictionLaw::powers, "viscous_load_exponent",
              "exponent of the load in the viscous moment"),
};
constexpr std::string_view replenishment =
    "replenishment constant; bath or jet: 3e-8, grease or oil-air: 6e-8, 0: no starvation of the "
    "film";
const Key skf_keys[]{
    number_of(FrictionLaw::skf, "mu_bl", "friction coefficient of boundary lubrication"),
    number_of(FrictionLaw::skf, "mu_EHL", "friction coefficient of a full film"),
    number_of(FrictionLaw::skf, "K_rs", replenishment),
};
const Key contact_law_keys[]{
    number_of(FrictionLaw::contact, "rolling_factor",
              "factor on the rolling resistance of the oil"),
    number_of(FrictionLaw::contact, "hysteresis_factor",
              "factor on the hysteresis of the material"),
    number_of(FrictionLaw::contact, "mu_boundary", "friction coefficient of the asperity contacts"),
    number_of(FrictionLaw::contact, "K_rs", replenishment),
    number_of(FrictionLaw::contact, "oil_fraction",
              "share of oil in the free space through which the balls move; 0: no drag"),
};

const Key table_law_keys[]{
    number_of(FrictionLaw::table, "scale", "factor on the torque of the table"),
};

const std::string words_of_roller_law = names_as_words(friction::roller_friction_laws);
const std::string words_of_roller_load = names_as_words(std::array{F1Load::F_r, F1Load::rollers});
const Key roller_law_keys[]{
    {"law", one_of(words_of_roller_law), "palmgren", "base law of friction"}};
const Key roller_load_keys[]{
    {"f1_load", one_of(words_of_roller_load), "rollers",
     "load in the law: rollers (sum of the roller loads, so that a preload causes torque), or F_r "
     "(radial load, as in the published laws)"},
};
const Key roller_f0 = [] {
  Key key = number_of(FrictionLaw::roller_palmgren, "f0", "factor of the viscous moment");
  key.fallback = "grease 0.8, oil-air 1.5, bath 3, jet 6; 1.5 without the key supply";
  return key;
}();
const Key roller_palmgren_keys[]{
    roller_f0,
    number_of(FrictionLaw::roller_palmgren, "f1",
              "factor of the load moment f1 F d_m, usually 0.0002 to 0.0004"),
};
const Key roller_skf_keys[]{
    number_of(FrictionLaw::roller_skf, "mu_bl", "friction coefficient of boundary lubrication"),
    number_of(FrictionLaw::roller_skf, "mu_EHL", "friction coefficient of a full film"),
    number_of(FrictionLaw::roller_skf, "K_rs", replenishment),
};

/// True for f0, z and y.
bool is_of_palmgren(std::string_view name) {
  const auto numbers = friction::parameters(FrictionLaw::palmgren);
  return std::any_of(numbers.begin(), numbers.end(),
                     [&](const friction::Parameter& p) { return p.name == name; });
}

/// Those that stand with a law alone.
Keys keys_of_law(FrictionLaw law) {
  switch (law) {
    case FrictionLaw::palmgren:
      return {palmgren_keys};
    case FrictionLaw::skf:
      return {skf_keys};
    case FrictionLaw::contact:
      return {contact_law_keys, contact_keys("friction")};
    case FrictionLaw::table:
      return {table_law_keys};
    case FrictionLaw::powers:
    case FrictionLaw::contact_powers:
      return {palmgren_keys, powers_keys};
    case FrictionLaw::roller_palmgren:
      return {roller_palmgren_keys};
    case FrictionLaw::roller_skf:
      break;
  }
  return {roller_skf_keys};
}

bool has(FrictionLaw law, std::string_view name) {
  for (const std::span<const Key> part : keys_of_law(law))
    for (const Key& key : part)
      if (key.name == name) return true;
  return false;
}

std::string belongs_to_others(std::string_view key, const toml::node& value,
                              std::span<const FrictionLaw> others, FrictionLaw law) {
  std::vector<std::string> names;
  for (const FrictionLaw other : others)
    if (has(other, key)) names.push_back(fmt::format("\"{}\"", friction::name(other)));
  return fmt::format("{} = {}: this key is only for law = {}, but the law is \"{}\"", key,
                     text::shown(value), text::listed(names, "or"), friction::name(law));
}

/// `others`: laws of the same kind of bearing.
void refuse_values_of_other_law(const Section& s, FrictionLaw law,
                                std::span<const FrictionLaw> others) {
  if (!s.given()) return;
  for (const auto& [key, node] : *s.table())
    if (const std::string_view name = key.str();
        !has(law, name) && std::any_of(others.begin(), others.end(),
                                       [&](FrictionLaw other) { return has(other, name); }))
      s.fail(key.str(), belongs_to_others(name, node, others, law));
}

/// Fills in what the law of `result` reads in a table.
void read_values_of_rollers(ModelTables& tables, const Section& s,
                            std::optional<friction::Supply> supply, LawOfFile& result) {
  result.f1_load =
      tables.choice(s, "f1_load") == friction::name(F1Load::F_r) ? F1Load::F_r : F1Load::rollers;
  for (const friction::Parameter& p : friction::parameters(result.law))
    result.values.push_back(
        tables.number(s, p.name, p.name == "f0" ? friction::usual_roller_f0(supply) : p.initial));
}

/// The friction table that a model names; null without.
std::shared_ptr<const friction::TorqueTable> read_table_of_law(ModelTables& tables,
                                                               const Section& s, FrictionLaw law) {
  const auto file = s.text("file");
  if (!file) {
    if (law == FrictionLaw::table)
      s.fail_missing("file",
                     ": the law table needs a CSV with speed_rpm, axial_load_N, radial_load_N, "
                     "temperature_C and friction_torque_Nmm");
    return nullptr;
  }
  friction::TorqueTable table;
  try {
    table = parse_friction_table(tables.files().read(*file).text, tables.files().shown(*file));
  } catch (const text::InputError& e) {
    throw text::InputError(
        fmt::format("{}: file = \"{}\": {}", s.place(s.find("file")), *file, e.what()),
        s.at("file"));
  }
  table.file = *file;
  if (table.of_shaft)
    s.fail("file", fmt::format("file = \"{}\": the table is for a whole shaft, but this key needs "
                               "a table for one bearing (from a model without [arrangement])",
                               *file));
  for (const auto& [has, column] : {std::pair(table.has_axial_load, record::axial_load.name),
                                    std::pair(table.has_radial_load, record::radial_load.name),
                                    std::pair(table.has_temperature, record::temperature.name)})
    if (!has)
      tables.note_default(
          "friction", column, "all",
          fmt::format(
              "{} does not have this column, so its torques apply at all values of the quantity",
              *file));
  return std::make_shared<const friction::TorqueTable>(std::move(table));
}

/// A law of ball bearings, and the numbers that rollers have another one for.
void refuse_friction_of_balls(const Section& s) {
  if (s.text_or_empty("law") == friction::name(FrictionLaw::table))
    s.fail("law",
           "law = \"table\" is only for ball bearings; for cylindrical rollers, use \"palmgren\" "
           "or \"skf\"");
  if (s.text_or_empty("law") == friction::name(FrictionLaw::contact))
    s.fail("law",
           "law = \"contact\" is only for ball bearings; for cylindrical rollers, use \"palmgren\" "
           "or \"skf\"");
  for (const char* const key : {"z", "y"})
    if (const toml::node* const node = s.find(key))
      s.fail(key, fmt::format("{} = {}: this key is only for ball bearings; the load moment "
                              "of cylindrical rollers is f1 F d_m with a constant f1",
                              key, text::shown(*node)));
}

}  // namespace

std::vector<KeyTable> friction_tables() {
  std::vector<KeyTable> tables{{"lubricant", lubricant_keys},
                               {"lubricant", contact_keys("lubricant")},
                               {"friction", law_keys}};
  for (const auto& [law, only] :
       {std::pair(FrictionLaw::palmgren, "law palmgren"), std::pair(FrictionLaw::skf, "law skf"),
        std::pair(FrictionLaw::contact, "law contact"), std::pair(FrictionLaw::table, "law table")})
    for (const std::span<const Key> keys : keys_of_law(law))
      tables.push_back({"friction", keys, only});
  tables.push_back({"friction", powers_keys, "laws powers and contact-powers"});
  tables.push_back({"friction", roller_law_keys, "cylindrical rollers"});
  tables.push_back({"friction", roller_load_keys, "cylindrical rollers"});
  tables.push_back({"friction", roller_palmgren_keys, "cylindrical rollers, law palmgren"});
  tables.push_back({"friction", roller_skf_keys, "cylindrical rollers, law skf"});
  return tables;
}

LubricantOfFile read_lubricant(const ModelTables& tables) {
  const Section s =
      tables.required_section("lubricant", "viscosity_40C_mm2_s and viscosity_100C_mm2_s",
                              {lubricant_keys, contact_keys("lubricant")});
  const auto supply = s.choice("supply");
  try {
    return {.lubricant = {s.required("viscosity_40C_mm2_s") * mm2_per_s,
                          s.required("viscosity_100C_mm2_s") * mm2_per_s},
            .supply = supply ? friction::find_supply(*supply) : std::nullopt};
  } catch (const std::invalid_argument& error) {
    // "viscosity_40C" and "viscosity_100C" are the libraries' names of the two keys.
    s.fail(error);
  }
}

LawOfFile read_friction(ModelTables& tables, bool from_catalogue, const Keys& further) {
  const Section table = from_catalogue
                            ? tables.section("friction")
                            : tables.required_section("friction", "the base law and its factors");
  LawOfFile result{
      .law = *friction::find_friction_law(tables.choice(table.part({law_keys}), "law")),
      .values = {}};
  refuse_values_of_other_law(table, result.law, friction::all_friction_laws);
  Keys known{law_keys};
  for (const Keys& keys : {keys_of_law(result.law), further})
    known.insert(known.end(), keys.begin(), keys.end());
  const Section s = table.with(known);
  if (friction::has_palmgren_load(result.law))
    result.f1_load =
        tables.choice(s, "f1_load") == friction::name(F1Load::P0) ? F1Load::P0 : F1Load::F_b;
  // The factors of the SKF law are published constants, those of the contacts are 1; those of
  // Palmgren depend on the bearing, and only a catalogue's user may leave them out.
  const auto required = [&](const friction::Parameter& p) {
    return friction::has_palmgren_load(result.law) && !from_catalogue && is_of_palmgren(p.name);
  };
  for (const friction::Parameter& p : friction::parameters(result.law))
    result.values.push_back(friction::of_the_lubricant(p) ? lubricant_number(tables, p.name)
                            : required(p)                 ? s.required(p.name)
                                                          : tables.number(s, p.name));
  result.table = read_table_of_law(tables, s, result.law);
  return result;
}

Keys palmgren_keys_of_rollers() { return {roller_palmgren_keys, roller_load_keys}; }

LawOfFile read_palmgren_of_rollers(ModelTables& tables, const Section& s,
                                   std::optional<friction::Supply> supply) {
  LawOfFile result{.law = FrictionLaw::roller_palmgren, .values = {}};
  read_values_of_rollers(tables, s.part(palmgren_keys_of_rollers()), supply, result);
  return result;
}

LawOfFile read_friction_of_rollers(ModelTables& tables, std::optional<friction::Supply> supply) {
  const Section table = tables.section("friction");
  refuse_friction_of_balls(table);
  LawOfFile result{
      .law = *friction::find_roller_law(tables.choice(table.part({roller_law_keys}), "law")),
      .values = {}};
  refuse_values_of_other_law(table, result.law, friction::roller_friction_laws);
  Keys known{roller_law_keys, roller_load_keys};
  for (const std::span<const Key> keys : keys_of_law(result.law)) known.push_back(keys);
  read_values_of_rollers(tables, table.with(known), supply, result);
  return result;
}

Names missing_keys_of_friction(const ModelTables& tables) {
  Names missing = tables.part("lubricant", {lubricant_keys})
                      .lacking({"viscosity_40C_mm2_s", "viscosity_100C_mm2_s"});
  if (has_rollers(tables)) return missing;
  const Section s = tables.part("friction", {law_keys, palmgren_keys});
  const Section bearing = tables.part("bearing", {bearing_keys()});
  if (bearing.find("catalogue") ||
      !friction::has_palmgren_load(friction::find_friction_law(s.text("law").value_or("palmgren"))
                                       .value_or(FrictionLaw::skf)))
    return missing;
  for (const std::string& one : bearing.lacking({"static_load_rating_N"})) missing.push_back(one);
  for (const friction::Parameter& p : friction::parameters(FrictionLaw::palmgren))
    for (const std::string& one : s.lacking({p.name})) missing.push_back(one);
  return missing;
}

void require_data(FrictionLaw law, const bearing::Bearing& bearing, const Section& table) {
  const Section s = table.part({bearing_keys()});
  if (friction::has_palmgren_load(law) && std::isnan(bearing.geometry().static_load_rating))
    s.fail_missing("static_load_rating_N",
                   fmt::format(", which the friction law {} needs", friction::name(law)));
  try {
    friction::require_data(law, bearing);
  } catch (const std::invalid_argument& error) {
    s.fail(error);
  }
}

}  // namespace raceway::files
