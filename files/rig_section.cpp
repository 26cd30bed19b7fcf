#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/rig_section.h"

namespace raceway::files {
namespace {

constexpr model::Rig usual_rig;
constexpr Key rig_keys[]{
    {"inertia_kgm2", between(1e-9, 1e6, "kg m2"), unset,
     "moment of inertia of all rotating parts, a number or \"unknown\"; required for coast-down "
     "records"},
    {"bearings", whole(1, 100), static_cast<double>(usual_rig.bearings),
     "number of bearings on the rig; the reading is the sum of their torques"},
    {"axial_load_N", between(0, 1e8, "N"), unset,
     "axial load of one bearing, for records without a column axial_load_N"},
    {"radial_load_N", between(0, 1e8, "N"), usual_rig.radial_load,
     "radial load of one bearing, for records without a column radial_load_N"},
    {"temperature_C", between(-273, 500, "C"), celsius(usual_rig.temperature),
     "lubricant temperature, for records without a column temperature_C"},
    {"room_temperature_C", between(-273, 500, "C"),
     "temperature of the coldest row (for diagnose and add)",
     "room temperature, for the effect temperature-gain"},
    {"minimum_speed_rpm", between(0, 1e6, "rpm"), usual_rig.minimum_speed / rpm,
     "lowest speed of the coast-down rows that the program uses; a note gives the number of slower "
     "rows"},
};

constexpr Key race_control_keys[]{
    {"race_control", one_of("outer|inner|balanced"), "outer",
     "assumption about ball spin: no spin at the outer race, no spin at the inner race, or (with "
     "law = \"contact\") equilibrium of the tractions"},
};
constexpr Key tilt_keys[]{
    {"tilt", one_of("locked|free"), "locked",
     "tilt of the inner ring: locked at 0, or free (the tilt then follows from the tilting "
     "moments, which are 0 by default)"},
};

/// The number, or the word for one that nobody knows.
void read_inertia(const Section& s, model::Rig& rig) {
  constexpr std::string_view name = "inertia_kgm2";
  const toml::node* const node = s.find(name);
  if (!node) return;
  rig.unknown_inertia = node->is_string() && *node->value<std::string>() == "unknown";
  if (rig.unknown_inertia) return;
  if (node->is_string())
    s.fail(name, fmt::format("{} = {}: {}, or \"unknown\"", name, text::shown(*node),
                             range(s.key(name))));
  rig.inertia = s.number(name).value_or(unset);
}

bearing::Tilt tilt_of(ModelTables& tables, const Section& s) {
  return tables.choice(s, "tilt") == "locked" ? bearing::Tilt::locked : bearing::Tilt::free;
}

}  // namespace

std::vector<KeyTable> rig_tables() {
  return {{"rig", rig_keys}, {"solver", race_control_keys}, {"solver", tilt_keys}};
}

model::Rig read_rig(ModelTables& tables, Keys further) {
  further.insert(further.begin(), rig_keys);
  const Section s = tables.section("rig", std::move(further));
  model::Rig rig;
  read_inertia(s, rig);
  s.take("axial_load_N", rig.axial_load);
  if (const auto value = s.whole_number("bearings"))
    rig.bearings = *value;
  else
    tables.note_default("rig", "bearings", fmt::format("{}", rig.bearings));
  rig.radial_load = tables.number(s, "radial_load_N");
  rig.temperature = kelvin(tables.number(s, "temperature_C"));
  if (const auto value = s.number("room_temperature_C")) rig.room_temperature = kelvin(*value);
  rig.minimum_speed = tables.number(s, "minimum_speed_rpm") * rpm;
  return rig;
}

bearing::Tilt read_tilt(ModelTables& tables) {
  const Section table = tables.section("solver");
  if (const toml::node* const node = table.find("race_control"))
    table.fail("race_control",
               fmt::format("race_control = {}: this key is only for ball bearings, because "
                           "cylindrical rollers have a fixed axis of rotation",
                           text::shown(*node)));
  return tilt_of(tables, table.with({tilt_keys}));
}

SolverOfFile read_solver(ModelTables& tables, friction::FrictionLaw law, Keys further) {
  further.insert(further.begin(), {race_control_keys, tilt_keys});
  const Section s = tables.section("solver", std::move(further));
  SolverOfFile solver;
  const std::string control = tables.choice(s, "race_control");
  solver.balanced_balls = control == "balanced";
  if (solver.balanced_balls && law != friction::FrictionLaw::contact)
    s.fail("race_control",
           "race_control = \"balanced\": needs [friction] law = \"contact\", because only this law "
           "calculates the tractions of the contacts");
  bearing::EquilibriumOptions& options = solver.options;
  if (control == "inner") options.race_control = bearing::RaceControl::inner;
  options.tilt = tilt_of(tables, s);
  return solver;
}

}  // namespace raceway::files
