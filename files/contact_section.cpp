#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "friction/contact/contact_law.h"
#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/contact_section.h"

namespace raceway::files {
namespace {

using friction::contact::OilType;

constexpr friction::contact::OilDefaults usual_oil = oil_defaults(OilType::mineral);
const friction::contact::ContactData usual_contact;
const record::NumberCard& traction_card =
    *std::find_if(friction::contact::contact_parameters.begin(),
                  friction::contact::contact_parameters.end(), friction::of_the_lubricant);
const std::string words_of_oil =
    names_as_words(std::array{OilType::mineral, OilType::pao, OilType::ester});

const Key contact_lubricant_keys[]{
    {"type", one_of(words_of_oil), "mineral",
     "type of the oil, which determines the defaults of its pressure-viscosity coefficient, "
     "density, thermal conductivity and limiting traction; for the law contact"},
    {"pressure_viscosity_1_GPa", between(3, 40, "1/GPa"), "from type and viscosity",
     "pressure-viscosity coefficient; for the law contact"},
    {"density_15C_kg_m3", between(600, 2000, "kg/m3"), usual_oil.density_15C,
     "density of the oil; the default depends on the type (shown: mineral); for the law contact"},
    {"conductivity_W_mK", between(0.05, 1, "W/(m K)"), usual_oil.conductivity,
     "thermal conductivity of the oil; the default depends on the type (shown: mineral); for the "
     "law contact"},
    {"limiting_traction", between(traction_card), usual_oil.limiting_traction,
     "largest ratio of traction to pressure in the oil; the default depends on the type (shown: "
     "mineral); for the law contact"},
    {"eyring_stress_MPa", between(0.5, 30, "MPa"), friction::contact::default_eyring_stress / MPa,
     "shear stress above which the oil shows shear thinning; for the law contact"},
};
const Key contact_bearing_keys[]{
    {"race_roughness_um", between(0.002, 2, "um"), usual_contact.race_roughness / um,
     "roughness Rq of the grooves; for the law contact"},
    {"ball_roughness_um", between(0.002, 2, "um"), usual_contact.ball_roughness / um,
     "roughness Rq of the balls; for the law contact"},
};
const Key contact_friction_keys[]{
    {"inlet_over_b", between(1.05, 100), unset,
     "distance from the centre of the contact to the oil meniscus at the contact inlet, divided by "
     "the half width b of the contact; without this key, the film thickness is the value for a "
     "flooded inlet"},
    // Zhou and Hoeprich's share of the asperities; their numbers belong to a surface.
    {"asperity_factor", between(0.1, 10), usual_contact.asperities.B,
     "coefficient B in the load share of the asperities, exp(-B lambda^C), with the film ratio "
     "lambda"},
    {"asperity_exponent", between(0.2, 5), usual_contact.asperities.C,
     "exponent C in the load share of the asperities, exp(-B lambda^C), with the film ratio "
     "lambda"},
};

constexpr model::LifeData usual_life;
constexpr Key life_keys[]{
    {"dynamic_load_rating_N", between(1, 1e9, "N"), "calculated by ISO 281 from the geometry",
     "dynamic load rating C"},
    {"fatigue_load_N", between(0.01, 1e8, "N"), "calculated by ISO 281 from the geometry",
     "fatigue load limit C_u"},
    {"contamination", between(0, 1), usual_life.contamination,
     "contamination factor e_C of ISO 281"},
    {"reliability", between(90, 99.95, "%"), usual_life.reliability,
     "reliability for which the life is calculated"},
};

using friction::contact::ContactData;
using friction::contact::OilDefaults;
using friction::contact::OilType;

Section oil_table(const ModelTables& tables) {
  return tables.part("lubricant", {contact_lubricant_keys});
}

OilType type_of(const Section& oil) {
  const auto given = oil.choice("type");
  return given ? *friction::contact::find_oil_type(*given) : OilType::mineral;
}

}  // namespace

std::span<const Key> contact_keys(std::string_view table) {
  if (table == "bearing") return contact_bearing_keys;
  if (table == "friction") return contact_friction_keys;
  return contact_lubricant_keys;
}

std::vector<KeyTable> contact_tables() {
  return {{"bearing", contact_bearing_keys}, {"life", life_keys}};
}

Names written_contact_keys(const ModelTables& tables) {
  Names written;
  for (const std::string_view table : {"lubricant", "bearing"})
    for (const Key& key : contact_keys(table))
      if (tables.section(table).find(key.name)) written.emplace_back(key.name);
  return written;
}

double lubricant_number(ModelTables& tables, std::string_view name) {
  const Section oil = oil_table(tables);
  return tables.number(oil, name, oil_defaults(type_of(oil)).limiting_traction);
}

ContactData read_contact(ModelTables& tables, bool used, std::optional<friction::Supply> supply) {
  const Section oil = oil_table(tables), bearing = tables.part("bearing", {contact_bearing_keys}),
                law = tables.part("friction", {contact_friction_keys});
  ContactData data;
  const auto number = [&](const Section& s, std::string_view key, double fallback) {
    return used ? tables.number(s, key, fallback) : s.number(key).value_or(fallback);
  };
  const auto number_or_default = [&](const Section& s, std::string_view key) {
    return number(s, key, s.key(key).fallback.value);
  };
  data.oil.type = type_of(oil);
  if (used && !oil.find("type"))
    tables.note_default("lubricant", "type", fmt::format("\"{}\"", name(data.oil.type)));
  const OilDefaults usual = oil_defaults(data.oil.type);
  data.oil.density_15C = number(oil, "density_15C_kg_m3", usual.density_15C);
  data.oil.conductivity = number(oil, "conductivity_W_mK", usual.conductivity);
  if (const auto given = oil.number("pressure_viscosity_1_GPa"))
    data.oil.pressure_viscosity = *given / GPa;
  else if (used)
    tables.note_default(
        "lubricant", "pressure_viscosity_1_GPa",
        fmt::format("{} nu^{}", usual.pressure_viscosity_s, usual.pressure_viscosity_t),
        fmt::format("default for {} oil in 1/GPa, with the kinematic viscosity nu in mm2/s",
                    name(data.oil.type)));
  data.eyring_stress = number_or_default(oil, "eyring_stress_MPa") * MPa;
  oil.take("limiting_traction", data.limiting_traction);
  data.supply = friction::contact::inlet_of(supply);
  if (used && !supply)
    tables.note_default(
        "lubricant", "supply", "limited",
        "default: little oil at the contact inlets, as with oil-air, grease or jet");
  law.take("inlet_over_b", data.inlet_over_b);
  data.asperities.B = law.value("asperity_factor");
  data.asperities.C = law.value("asperity_exponent");
  data.race_roughness = number_or_default(bearing, "race_roughness_um") * um;
  data.ball_roughness = number_or_default(bearing, "ball_roughness_um") * um;
  return data;
}

model::LifeData read_life(ModelTables& tables) {
  const Section s = tables.section("life", {life_keys});
  model::LifeData life;
  s.take("dynamic_load_rating_N", life.dynamic_load_rating);
  s.take("fatigue_load_N", life.fatigue_load);
  life.contamination = s.value("contamination");
  life.reliability = s.value("reliability");
  return life;
}

}  // namespace raceway::files
