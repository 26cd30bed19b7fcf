#include <cmath>
#include <vector>

#include "record/units.h"

// Last: see io/toml_text.h.
#include "io/contact_section.h"

namespace raceway::io {
namespace {

using friction::contact::ContactData;
using friction::contact::OilDefaults;
using friction::contact::OilType;

constexpr std::string_view type_key = "type";
constexpr Key pressure_viscosity{"pressure_viscosity_1_GPa", "1/GPa", 3, 40};
constexpr Key oil_density_key{"density_15C_kg_m3", "kg/m3", 600, 2000};
constexpr Key oil_conductivity_key{"conductivity_W_mK", "W/(m K)", 0.05, 1};
constexpr Key limiting_traction{"limiting_traction", "", 0.01, 0.2};
constexpr Key eyring_stress{"eyring_stress_MPa", "MPa", 0.5, 30};
constexpr Key inlet_over_b{"inlet_over_b", "", 1.05, 100};
constexpr Key race_roughness{"race_roughness_um", "um", 0.002, 2};
constexpr Key ball_roughness{"ball_roughness_um", "um", 0.002, 2};
// Zhou and Hoeprich's share of the asperities; their numbers belong to a surface.
constexpr Key asperity_factor{"asperity_factor", "", 0.1, 10};
constexpr Key asperity_exponent{"asperity_exponent", "", 0.2, 5};

constexpr Key load_rating{"dynamic_load_rating_N", "N", 1, 1e9};
constexpr Key fatigue_load{"fatigue_load_N", "N", 0.01, 1e8};
constexpr Key contamination{"contamination", "", 0, 1};
constexpr Key reliability{"reliability", "%", 90, 99.95};

OilType type_of(const Section& lubricant) {
  Names types;
  for (const OilType type : {OilType::mineral, OilType::pao, OilType::ester})
    types.emplace_back(name(type));
  const auto given = lubricant.choice(type_key, types);
  return given ? *friction::contact::find_oil_type(*given) : OilType::mineral;
}

}  // namespace

Names contact_keys(std::string_view table) {
  if (table == "bearing")
    return {std::string(race_roughness.name), std::string(ball_roughness.name)};
  if (table == "friction")
    return {std::string(inlet_over_b.name), std::string(asperity_factor.name),
            std::string(asperity_exponent.name)};
  Names names{std::string(type_key)};
  for (const Key& key : {pressure_viscosity, oil_density_key, oil_conductivity_key,
                         limiting_traction, eyring_stress})
    names.emplace_back(key.name);
  return names;
}

Names written_contact_keys(const ModelTables& tables) {
  Names written;
  for (const std::string_view table : {"lubricant", "bearing"})
    for (std::string& key : contact_keys(table))
      if (tables.section(table).find(key)) written.push_back(std::move(key));
  return written;
}

double default_of_lubricant(const ModelTables& tables) {
  return oil_defaults(type_of(tables.section("lubricant"))).limiting_traction;
}

ContactData read_contact(ModelTables& tables, bool used, std::optional<friction::Supply> supply) {
  const Section oil = tables.section("lubricant"), bearing = tables.section("bearing"),
                law = tables.section("friction");
  ContactData data;
  const auto number = [&](const Section& s, const Key& key, double fallback) {
    return used ? tables.number_or(s, key, fallback) : s.number(key).value_or(fallback);
  };
  data.oil.type = type_of(oil);
  if (used && !oil.find(type_key))
    tables.note_default("lubricant", type_key, fmt::format("\"{}\"", name(data.oil.type)));
  const OilDefaults usual = oil_defaults(data.oil.type);
  data.oil.density_15C = number(oil, oil_density_key, usual.density_15C);
  data.oil.conductivity = number(oil, oil_conductivity_key, usual.conductivity);
  if (const auto given = oil.number(pressure_viscosity))
    data.oil.pressure_viscosity = *given / GPa;
  else if (used)
    tables.note_default(
        "lubricant", pressure_viscosity.name,
        fmt::format("{} nu^{}", usual.pressure_viscosity_s, usual.pressure_viscosity_t),
        fmt::format("default of {} oil, nu in mm2/s", name(data.oil.type)));
  data.eyring_stress =
      number(oil, eyring_stress, friction::contact::default_eyring_stress / MPa) * MPa;
  if (const auto given = oil.number(limiting_traction)) data.limiting_traction = *given;
  data.supply = friction::contact::inlet_of(supply);
  if (used && !supply)
    tables.note_default("lubricant", "supply", "limited",
                        "default: inlets as oil-air, grease and jet leave them");
  if (const auto given = law.number(inlet_over_b)) data.inlet_over_b = *given;
  if (const auto given = law.number(asperity_factor)) data.asperities.B = *given;
  if (const auto given = law.number(asperity_exponent)) data.asperities.C = *given;
  data.race_roughness = number(bearing, race_roughness, data.race_roughness / um) * um;
  data.ball_roughness = number(bearing, ball_roughness, data.ball_roughness / um) * um;
  return data;
}

model::LifeData read_life(ModelTables& tables) {
  const Section s = tables.section("life");
  s.allow_only({std::string(load_rating.name), std::string(fatigue_load.name),
                std::string(contamination.name), std::string(reliability.name)});
  model::LifeData life;
  if (const auto given = s.number(load_rating)) life.dynamic_load_rating = *given;
  if (const auto given = s.number(fatigue_load)) life.fatigue_load = *given;
  if (const auto given = s.number(contamination)) life.contamination = *given;
  if (const auto given = s.number(reliability)) life.reliability = *given;
  return life;
}

}  // namespace raceway::io
