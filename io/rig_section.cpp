#include "record/units.h"

// Last: see io/toml_text.h.
#include "io/rig_section.h"

namespace raceway::io {
namespace {

constexpr Key inertia{"inertia_kgm2", "kg m2", 1e-9, 1e6};
constexpr Key bearing_count{"bearings", "", 1, 100};
constexpr Key axial_load{"axial_load_N", "N", 0, 1e8};
constexpr Key radial_load{"radial_load_N", "N", 0, 1e8};
constexpr Key temperature{"temperature_C", "C", -273, 500};
constexpr Key room_temperature{"room_temperature_C", "C", -273, 500};
constexpr Key minimum_speed{"minimum_speed_rpm", "rpm", 0, 1e6};

/// The number, or the word for one that nobody knows.
void read_inertia(const Section& s, model::Rig& rig) {
  const toml::node* const node = s.find(inertia.name);
  if (!node) return;
  rig.unknown_inertia = node->is_string() && *node->value<std::string>() == "unknown";
  if (rig.unknown_inertia) return;
  if (node->is_string())
    s.fail(inertia.name,
           fmt::format("{} = {}: {}, or \"unknown\"", inertia.name, shown(*node), range(inertia)));
  rig.inertia = s.number(inertia).value_or(unset);
}

}  // namespace

model::Rig read_rig(ModelTables& tables, const Names& further) {
  const Section s = tables.section("rig");
  Names known;
  for (const Key& key : {inertia, bearing_count, axial_load, radial_load, temperature,
                         room_temperature, minimum_speed})
    known.emplace_back(key.name);
  known.insert(known.end(), further.begin(), further.end());
  s.allow_only(known);
  model::Rig rig;
  read_inertia(s, rig);
  if (const auto value = s.number(axial_load)) rig.axial_load = *value;
  if (const auto value = s.whole_number(bearing_count))
    rig.bearings = *value;
  else
    tables.note_default("rig", bearing_count.name, fmt::format("{}", rig.bearings));
  rig.radial_load = tables.number_or(s, radial_load, rig.radial_load);
  rig.temperature = kelvin(tables.number_or(s, temperature, celsius(rig.temperature)));
  if (const auto value = s.number(room_temperature)) rig.room_temperature = kelvin(*value);
  rig.minimum_speed = tables.number_or(s, minimum_speed, rig.minimum_speed / rpm) * rpm;
  return rig;
}

SolverOfFile read_solver(ModelTables& tables, friction::FrictionLaw law, const Names& further) {
  const Section s = tables.section("solver");
  Names known{"race_control", "tilt"};
  known.insert(known.end(), further.begin(), further.end());
  s.allow_only(known);
  SolverOfFile solver;
  const std::string control =
      tables.choice_or(s, "race_control", {"outer", "inner", "balanced"}, "outer");
  solver.balanced_balls = control == "balanced";
  if (solver.balanced_balls && law != friction::FrictionLaw::contact)
    s.fail("race_control",
           "race_control = \"balanced\": the balls turn by the traction of their contacts, which "
           "[friction] law = \"contact\" alone knows");
  bearing::EquilibriumOptions& options = solver.options;
  if (control == "inner") options.race_control = bearing::RaceControl::inner;
  options.tilt = tables.choice_or(s, "tilt", {"locked", "free"}, "locked") == "locked"
                     ? bearing::Tilt::locked
                     : bearing::Tilt::free;
  return solver;
}

}  // namespace raceway::io
