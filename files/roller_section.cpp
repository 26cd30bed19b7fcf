#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "friction/roller_friction.h"
#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/contact_section.h"
#include "files/detail/effect_section.h"
#include "files/detail/friction_section.h"
#include "files/detail/rig_section.h"
#include "files/detail/roller_section.h"
#include "files/detail/spindle_parts.h"
#include "files/detail/spindle_section.h"

namespace raceway::files {
namespace {

using bearing::RollerGeometry;

constexpr std::string_view roller_type = "cylindrical-roller";

constexpr Key type_keys[]{
    {"type", one_of("ball|cylindrical-roller"), "ball",
     "type of the rolling elements; cylindrical rollers have other keys"},
};

// Wherever the libraries check as well, these are their ranges.
constexpr Key keys_of_rollers[]{
    {"name", a_text, "name of the file", "name in the results"},
    {"roller_count", whole(4, 200), is_required,
     "number of rollers; they must fit on 98 % of the pitch circle"},
    {"roller_diameter_mm", between(0.5, 300, "mm"), is_required, "diameter of a roller"},
    {"roller_length_mm", between(0.5, 3000, "mm"), is_required,
     "effective length of a roller, without the chamfers; at most 10 roller diameters, and at most "
     "the ring width"},
    {"pitch_diameter_mm", between(1, 5000, "mm"), is_required,
     "diameter of the circle through the roller axes, above 2 roller diameters"},
    {"bore_mm", between(0, 5000, "mm"), unset,
     "bore of the inner ring, below its raceway diameter; required by the law skf"},
    {"outer_diameter_mm", between(1, 10000, "mm"), unset,
     "outer diameter of the outer ring, from 1 to 2 times its raceway diameter; required by the "
     "law skf"},
    {"width_mm", between(0.5, 5000, "mm"), unset, "ring width, at least the roller length"},
    {"radial_clearance_um", between(-100, 1000, "um"), 0.0,
     "diametral clearance; a negative value is a preload. On a rig: clearance in operation"},
    {"radial_clearance_of", one_of("mounted|free"), "mounted",
     "state for which the clearance is given: mounted on the seats (cold, at standstill), or free "
     "before mounting. A rig has no seats and uses the value unchanged"},
    {"taper", between(0, 100), 0.0,
     "taper of the bore, 12 for 1:12, at least 5; 0 for a cylindrical bore. No effect on a rig"},
    {"profile", one_of("iso|none"), "iso",
     "profile of the rollers: logarithmic crowning by ISO/TS 16281, or none (straight)"},
    {"roller_material", one_of("steel|silicon-nitride"), "steel",
     "material: a built-in name, or the NAME of a table [material.NAME]"},
    {"ring_material", one_of("steel|silicon-nitride"), "steel",
     "material: a built-in name, or the NAME of a table [material.NAME]"},
    {"static_load_rating_N", between(1, 1e9, "N"),
     "44 (1 - D/d_m) Z L D (roller diameter D, pitch diameter d_m, Z rollers of length L)",
     "static load rating C0"},
};
/// Those of the geometry, without name and rating.
constexpr std::span<const Key> keys_of_geometry =
    std::span(keys_of_rollers).subspan(1, std::size(keys_of_rollers) - 2);

constexpr Key keys_on_shaft[]{
    {"name", a_text, is_required,
     "name of the bearing (letters, digits and _) in columns such as NAME_clearance_um and "
     "NAME_radial_force_N"},
    {"position_mm", on_the_shaft, is_required,
     "distance of the bearing centre behind the nose face"},
    {"inner_interference_um", between(-500, 500, "um"), "value in [seat]",
     "diametral interference of the inner ring on the shaft"},
    {"drive_up_mm", between(0, 50, "mm"), unset,
     "distance by which the inner ring is driven up the taper; replaces inner_interference_um"},
    {"outer_clearance_um", between(-500, 500, "um"), "value in [seat]",
     "diametral clearance of the outer ring in the housing"},
    {"lubricant_conductance_W_K", between(0, 1000, "W/K"), "value in [bearing]",
     "thermal conductance from ring to ring through oil and rollers, in addition to the contacts"},
};

bool has(std::span<const Key> keys, std::string_view name) {
  return std::any_of(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
}

/// These keys hold for balls and rollers alike.
constexpr std::string_view width_key = "width_mm";

void refuse_keys_of_balls(const Section& s) {
  for (const std::span<const Key> keys : {bearing_keys(), contact_keys("bearing")})
    for (const Key& key : keys) {
      const toml::node* const node = s.find(key.name);
      if (!node || has(keys_of_rollers, key.name)) continue;
      const std::string of_rollers =
          key.name.starts_with("ball") ? "roller" + std::string(key.name.substr(4)) : "";
      s.fail(key.name,
             fmt::format("{} = {}: this key is only for ball bearings, but the type is \"{}\"{}",
                         key.name, text::shown(*node), roller_type,
                         has(keys_of_rollers, of_rollers) ? fmt::format("; use {}", of_rollers)
                                                          : std::string()));
    }
}

RollerGeometry read_roller_geometry(ModelTables& tables, const Section& s, double rating = unset) {
  RollerGeometry g;
  g.roller_count = *s.whole_number("roller_count");
  g.roller_diameter = s.required("roller_diameter_mm") * mm;
  g.roller_length = s.required("roller_length_mm") * mm;
  g.pitch_diameter = s.required("pitch_diameter_mm") * mm;
  // Unset where not given.
  g.bore = s.value("bore_mm") * mm;
  g.outer_diameter = s.value("outer_diameter_mm") * mm;
  g.width = s.value(width_key) * mm;
  g.radial_clearance = tables.number(s, "radial_clearance_um") * um;
  if (tables.choice(s, "radial_clearance_of") == "free")
    g.clearance_state = bearing::ClearanceState::free;
  g.taper = tables.number(s, "taper");
  if (tables.choice(s, "profile") == "none") g.profile = bearing::RollerProfile::none;
  g.static_load_rating = rating;
  try {
    return bearing::validated(g);
  } catch (const std::invalid_argument& error) {
    s.fail(error);
  }
}

struct RollersOfFile {
  bearing::RollerBearing bearing;
  std::string name;
};

RollersOfFile read_rollers(ModelTables& tables) {
  const Section table = tables.section("bearing");
  refuse_keys_of_balls(table);
  const Section s = table.with({type_keys, keys_of_rollers});
  const RollerGeometry geometry =
      read_roller_geometry(tables, s, s.number("static_load_rating_N").value_or(unset));
  std::string name = s.text("name").value_or("");
  if (name.empty()) {
    name = std::filesystem::path(tables.source()).stem().string();
    tables.note_default("bearing", "name", fmt::format("\"{}\"", name));
  }
  BearingReader materials(tables);
  return {bearing::RollerBearing(geometry, materials.material(s, "roller_material"),
                                 materials.material(s, "ring_material")),
          std::move(name)};
}

Keys all_keys_on_shaft() {
  Keys keys{keys_on_shaft, keys_of_geometry};
  for (const std::span<const Key> part : palmgren_keys_of_rollers()) keys.push_back(part);
  return keys;
}

std::string name_on_shaft(const Section& s, const std::vector<model::RollerOnShaft>& before) {
  std::string name = s.text("name").value_or("");
  if (!s.find("name")) s.fail_missing("name");
  const auto fail = [&](const std::string& why) {
    s.fail("name", fmt::format("name = \"{}\": {}", name, why));
  };
  if (!names_a_column(name))
    fail(
        "must be letters, digits and _, because it becomes part of column names such as "
        "NAME_clearance_um");
  for (const char* set : {"front_", "rear_"})
    if (name.starts_with(set))
      fail(
          "must not begin with front_ or rear_, because the bearings of the front and rear sets "
          "have such names");
  for (const model::RollerOnShaft& other : before)
    if (other.name == name) fail("another roller bearing has this name; choose another name");
  return name;
}

void read_seats_on_shaft(const Section& s, model::RollerOnShaft& roller) {
  const bearing::RollerGeometry& g = roller.bearing.geometry();
  for (const auto& [key, value] : {std::pair("bore_mm", g.bore),
                                   {"outer_diameter_mm", g.outer_diameter},
                                   {"width_mm", g.width}})
    if (std::isnan(value)) s.fail_missing(key, ", which a bearing on a shaft needs");
  const auto drive_up = s.number("drive_up_mm");
  if (const auto given = s.number("inner_interference_um")) {
    if (drive_up)
      s.fail(
          "drive_up_mm",
          "drive_up_mm and inner_interference_um both give the fit of the inner ring; remove one");
    roller.inner_interference = *given * um;
  }
  if (drive_up) {
    if (!(g.taper > 0.0))
      s.fail("drive_up_mm", fmt::format("drive_up_mm = {:.6g} mm: only possible with a tapered "
                                        "bore, such as taper = 12 for 1:12",
                                        *drive_up));
    roller.inner_interference = *drive_up * mm / g.taper;
  }
  s.take("outer_clearance_um", roller.outer_clearance, um);
  s.take("lubricant_conductance_W_K", roller.lubricant_conductance);
}

void refuse_sets_and_spindles(const ModelTables& tables) {
  Names others = tables_of_spindle();
  others.emplace_back("arrangement");
  for (const std::string& table : others)
    if (const toml::node* const node = tables.root().get(table))
      throw text::InputError(
          fmt::format(
              "{}:{}: [{}]: not possible with a [bearing] of type \"{}\", which is a "
              "single bearing on a rig. Bearing sets need ball bearings; for roller bearings of a "
              "spindle, use [[shaft.roller_bearing]]",
              tables.source(), node->source().begin.line, table, roller_type),
          {.file = tables.source(),
           .line = static_cast<int>(node->source().begin.line),
           .key = table});
}

model::Rig read_roller_rig(ModelTables& tables) {
  model::Rig rig = read_rig(tables, {});
  if (rig.axial_load > 0.0)
    tables.section("rig").fail("axial_load_N",
                               fmt::format("axial_load_N = {:g}: must be 0, because a cylindrical "
                                           "roller bearing of type N cannot carry an axial load",
                                           rig.axial_load));
  rig.axial_load = 0.0;
  return rig;
}

}  // namespace

std::span<const Key> keys_of_type() { return type_keys; }

std::vector<KeyTable> roller_tables() {
  std::vector<KeyTable> tables{{"bearing", type_keys},
                               {"bearing", keys_of_rollers, "cylindrical rollers"}};
  for (const std::span<const Key> keys : all_keys_on_shaft())
    tables.push_back({"shaft.roller_bearing", keys});
  return tables;
}

std::vector<model::RollerOnShaft> read_rollers_on_shaft(ModelTables& tables) {
  std::vector<model::RollerOnShaft> list;
  const std::vector<Section> sections =
      tables_in(tables.section("shaft"), "roller_bearing", all_keys_on_shaft());
  if (sections.empty()) return list;
  BearingReader materials(tables);
  const auto supply = read_lubricant(tables).supply;
  for (const Section& s : sections) {
    const LawOfFile law = read_palmgren_of_rollers(tables, s, supply);
    list.push_back(
        {.name = name_on_shaft(s, list),
         .position = s.required("position_mm") * mm,
         .bearing = {read_roller_geometry(tables, s), materials.material(s, "roller_material"),
                     materials.material(s, "ring_material")},
         .f0 = law.values[0],
         .f1 = law.values[1],
         .counted = law.f1_load});
    read_seats_on_shaft(s, list.back());
  }
  return list;
}

bool has_rollers(const ModelTables& tables) {
  return tables.section("bearing").text_or_empty("type") == roller_type;
}

void refuse_keys_of_rollers(const Section& bearing) {
  const auto type = bearing.part({type_keys}).choice("type");
  if (type == roller_type)
    bearing.fail(
        "type",
        fmt::format(
            "type = \"{}\": bearing sets need ball bearings; a roller bearing is possible as a "
            "single bearing on a rig, or in a spindle as [[shaft.roller_bearing]]",
            roller_type));
  for (const Key& key : keys_of_rollers) {
    const toml::node* const node = bearing.find(key.name);
    if (node && !has(bearing_keys(), key.name) && key.name != width_key)
      bearing.fail(
          key.name,
          fmt::format("{} = {}: this key is only for type = \"{}\", but this is a ball bearing",
                      key.name, text::shown(*node), roller_type));
  }
}

Names missing_keys_of_rollers(const ModelTables& tables) {
  return tables.part("bearing", {keys_of_rollers})
      .lacking({"roller_count", "roller_diameter_mm", "roller_length_mm", "pitch_diameter_mm"});
}

model::Model read_roller_model(ModelTables& tables) {
  refuse_sets_and_spindles(tables);
  RollersOfFile rollers = read_rollers(tables);
  const LubricantOfFile lubricant = read_lubricant(tables);
  LawOfFile law = read_friction_of_rollers(tables, lubricant.supply);
  try {
    friction::require_data(law.law, rollers.bearing);
  } catch (const std::invalid_argument& error) {
    tables.part("bearing", {keys_of_rollers}).fail(error);
  }
  std::vector<effects::Effect> effects = read_effects(tables, nullptr);
  bearing::EquilibriumOptions solver;
  solver.tilt = read_tilt(tables);
  const model::Rig rig = read_roller_rig(tables);
  return {.name = std::move(rollers.name),
          .bearing = std::move(rollers.bearing),
          .lubricant = lubricant.lubricant,
          .supply = lubricant.supply,
          .law = law.law,
          .f1_load = law.f1_load,
          .law_values = std::move(law.values),
          .contact = read_contact(tables, false, lubricant.supply),
          .effects = std::move(effects),
          .solver = solver,
          .life = read_life(tables),
          .rig = rig,
          .free = {}};
}

}  // namespace raceway::files
