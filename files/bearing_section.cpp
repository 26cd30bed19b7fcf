#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "files/catalogue_defaults.h"
#include "record/digits.h"
#include "record/units.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"
#include "files/detail/roller_section.h"

namespace raceway::files {
namespace {

// Wherever the libraries check as well, these are their ranges.
constexpr Key keys_of_bearing[]{
    {"catalogue", a_text, unset,
     "designation of a bearing; if the catalogue does not contain it, the program estimates its "
     "data. With this key, all other keys of this table are optional; a key that you give replaces "
     "the value of the catalogue"},
    {"name", a_text, "designation, or name of the model file", "name in the results"},
    {"ball_count", whole(3, 200), "value in the catalogue",
     "number of balls; they must fit on the pitch circle"},
    {"ball_diameter_mm", between(0.1, 300, "mm"), "value in the catalogue", "diameter of a ball"},
    {"pitch_diameter_mm", between(1, 5000, "mm"), "value in the catalogue",
     "diameter of the circle through the ball centres, above 1.2 ball diameters"},
    {"contact_angle_deg", between(0, 65, "deg"), "value in the catalogue",
     "nominal contact angle; 0 for a deep-groove bearing"},
    {"inner_conformity", between(0.5005, 0.7), catalogue_conformity,
     "radius of the inner groove / ball diameter; required without the key catalogue"},
    {"outer_conformity", between(0.5005, 0.7), catalogue_conformity,
     "radius of the outer groove / ball diameter; required without the key catalogue"},
    {"static_load_rating_N", between(1, 1e9, "N"), "value in the catalogue",
     "static load rating C0; required by the law palmgren"},
    {"ball_material", one_of("steel|silicon-nitride"), "steel",
     "material: a built-in name, or the NAME of a table [material.NAME]"},
    {"ring_material", one_of("steel|silicon-nitride"), "steel",
     "material: a built-in name, or the NAME of a table [material.NAME]"},
    {"bore_mm", between(0, 5000, "mm"), "pitch diameter - 1.5 ball diameters",
     "bore of the inner ring; must be below pitch diameter - ball diameter"},
    {"outer_diameter_mm", between(1, 10000, "mm"), "pitch diameter + 1.5 ball diameters",
     "outer diameter of the outer ring; must be above pitch diameter + ball diameter, and at most "
     "twice this sum"},
    {"radial_clearance_um", between(0, 10000, "um"), 0.0,
     "diametral clearance without load, for bearings with contact angle 0; must be below the "
     "distance between the groove centres"},
    {"inner_shoulder_diameter_mm", between(0.1, 5000, "mm"), unset,
     "diameter at which the inner groove ends, between groove bottom and pitch diameter; without "
     "this key, the program does not check the distance from the contact ellipse to the shoulder"},
    {"outer_shoulder_diameter_mm", between(1, 10000, "mm"), unset,
     "diameter at which the outer groove ends, between pitch diameter and groove bottom; without "
     "this key, the program does not check the distance from the contact ellipse to the shoulder"},
};

constexpr Key material_keys[]{
    {"elastic_modulus_GPa", between(1, 1200, "GPa"), is_required,
     "Young's modulus; steel: 208, silicon-nitride: 310"},
    {"poisson_ratio", between(0, 0.49), is_required,
     "Poisson's ratio; steel: 0.3, silicon-nitride: 0.26"},
    {"density_kg_m3", between(500, 20000, "kg/m3"), is_required,
     "density; steel: 7800, silicon-nitride: 3200"},
    {"thermal_expansion_1e6_K", between(0, 50, "1e-6/K"), is_required,
     "linear thermal expansion; steel: 11.5, silicon-nitride: 3.2"},
    // Balls and rings need neither.
    {"conductivity_W_mK", between(0.05, 2000, "W/(m K)"), unset,
     "thermal conductivity; required only for segments of a spindle"},
    {"heat_capacity_J_kgK", between(50, 5000, "J/(kg K)"), unset,
     "specific heat capacity; required only for segments of a spindle"},
};

using bearing::BearingGeometry;
using bearing::Material;

/// Numbers of a bearing that may be left to the catalogue, with their units.
struct GeometryNumber {
  std::string_view key;
  double BearingGeometry::*number;
  double unit = 1.0;
};
constexpr std::array lengths_and_ratios{
    GeometryNumber{"ball_diameter_mm", &BearingGeometry::ball_diameter, mm},
    GeometryNumber{"pitch_diameter_mm", &BearingGeometry::pitch_diameter, mm},
    GeometryNumber{"contact_angle_deg", &BearingGeometry::contact_angle, degree},
    GeometryNumber{"inner_conformity", &BearingGeometry::inner_conformity},
    GeometryNumber{"outer_conformity", &BearingGeometry::outer_conformity},
    GeometryNumber{"static_load_rating_N", &BearingGeometry::static_load_rating},
    GeometryNumber{"bore_mm", &BearingGeometry::bore, mm},
    GeometryNumber{"outer_diameter_mm", &BearingGeometry::outer_diameter, mm},
    GeometryNumber{"radial_clearance_um", &BearingGeometry::radial_clearance, um}};

/// The bearing of the catalogue with that very name; none without a catalogue.
std::optional<CatalogueBearing> row_named(const std::string& name) {
  try {
    for (const CatalogueBearing& row : read_catalogues())
      if (row.full_name() == name) return row;
  } catch (const text::InputError&) {
    // Whoever needs the catalogue is told so.
  }
  return std::nullopt;
}

/// An angle in rad and a load rating in kN would pass as odd bearings.
void refuse_other_units(const Section& s, const BearingGeometry& g) {
  if (g.contact_angle > 0.0 && g.contact_angle < 2.0 * degree && s.find("contact_angle_deg"))
    s.fail(
        "contact_angle_deg",
        fmt::format("contact_angle_deg = {:.4g}: must be 0, or from 2 to 65 deg; is the value in "
                    "rad?",
                    g.contact_angle / degree));
  // ISO 76: C0 = f0 Z D² cos α with f0 of 12 to 17 N/mm².
  const double usual =
      15e6 * g.ball_count * g.ball_diameter * g.ball_diameter * std::cos(g.contact_angle);
  if (g.static_load_rating * 100.0 < usual && s.find("static_load_rating_N"))
    s.fail("static_load_rating_N",
           fmt::format("static_load_rating_N = {:.6g}: {} balls of {:.4g} mm have a static load "
                       "rating of about {:.6g} N; is the value in kN?",
                       g.static_load_rating, g.ball_count, g.ball_diameter / mm,
                       record::with_digits(usual, 2)));
}

}  // namespace

std::vector<KeyTable> bearing_tables() {
  return {{"bearing", keys_of_bearing}, {"material.NAME", material_keys}};
}

std::span<const Key> bearing_keys() { return keys_of_bearing; }

std::vector<std::pair<std::string, double>> keys_of(const BearingGeometry& geometry) {
  std::vector<std::pair<std::string, double>> keys{
      {"ball_count", static_cast<double>(geometry.ball_count)}};
  for (const auto& [key, number, unit] : lengths_and_ratios)
    if (!std::isnan(geometry.*number))
      keys.emplace_back(key, text::with_15_digits(geometry.*number / unit));
  return keys;
}

Names missing_keys_of_bearing(const ModelTables& tables) {
  if (has_rollers(tables)) return missing_keys_of_rollers(tables);
  const Section s = tables.part("bearing", {keys_of_bearing});
  if (s.find("catalogue")) return {};
  return s.lacking({"ball_count", "ball_diameter_mm", "pitch_diameter_mm", "contact_angle_deg",
                    "inner_conformity", "outer_conformity"});
}

/// A bearing in the making.
struct BearingReader::Draft {
  BearingGeometry geometry;
  std::string name;
  std::optional<CatalogueBearing> row;
  bool from_catalogue = false;  ///< by this table
  bool ceramic_balls = false;   ///< by its designation
  std::string catalogue;        ///< that designation
};

BearingReader::BearingReader(ModelTables& tables)
    : tables_(tables), materials_{bearing::steel(), bearing::silicon_nitride()} {
  if (const toml::table* const table = tables.root()["material"].as_table())
    for (const auto& [key, node] : *table) read_material(key, node);
}

void BearingReader::read_material(const toml::key& key, const toml::node& node) {
  const std::string name(key.str());
  const std::string place = tables_.place(key);
  if (!node.is_table())
    throw text::InputError(
        fmt::format("{}: {} = {}: a material must be a table, written as [material.NAME]", place,
                    name, text::shown(node)),
        tables_.at(key));
  if (find_material(name))
    throw text::InputError(
        fmt::format(
            "{}: [material.{}]: this is the name of a built-in material; choose another name",
            place, name),
        tables_.at(key));
  const Section s(tables_.source(), "material." + name, node.as_table(), {material_keys});
  for (const char* of_heat : {"conductivity_W_mK", "heat_capacity_J_kgK"}) (void)s.number(of_heat);
  const Material material{
      .name = name,
      .elastic_modulus = s.required("elastic_modulus_GPa") * GPa,
      .poisson_ratio = s.required("poisson_ratio"),
      .density = s.required("density_kg_m3"),
      .thermal_expansion = s.required("thermal_expansion_1e6_K") * per_million_K};
  try {
    bearing::validate(material);
  } catch (const std::invalid_argument& error) {
    s.fail(error);
  }
  materials_.push_back(material);
}

const Material* BearingReader::find_material(std::string_view name) const {
  for (const Material& material : materials_)
    if (material.name == name) return &material;
  return nullptr;
}

NamedBearing BearingReader::read(const Section& table, const NamedBearing* base, Keys further) {
  refuse_keys_of_rollers(table);
  for (const std::span<const Key> keys : {std::span<const Key>(keys_of_bearing), keys_of_type()})
    further.insert(further.begin(), keys);
  const Section s = table.with(std::move(further));
  Draft draft;
  if (base) {
    draft.geometry = base->bearing.geometry();
    draft.row = base->row;
    draft.catalogue = base->catalogue;
    draft.name = base->name;
  }
  take_catalogue_row(s, base, draft);
  read_geometry(s, draft);
  read_envelope(s, draft.geometry);
  const Material* inherited = base ? &base->bearing.balls() : nullptr;
  if (draft.ceramic_balls && !s.find("ball_material")) {
    tables_.note_default(s.name(), "ball_material", "\"silicon-nitride\"", "from the designation");
    inherited = find_material("silicon-nitride");
  }
  const Material balls = material(s, "ball_material", inherited);
  const Material rings = material(s, "ring_material", base ? &base->bearing.rings() : nullptr);
  if (auto given = s.text("name")) draft.name = *given;
  note_written(s, draft);
  if (draft.name.empty()) {
    draft.name = std::filesystem::path(tables_.source()).stem().string();
    tables_.note_default("bearing", "name", fmt::format("\"{}\"", draft.name));
  }
  return {bearing::Bearing(draft.geometry, balls, rings), draft.name, draft.row, draft.catalogue};
}

void BearingReader::note_written(const Section& s, const Draft& draft) {
  const std::optional<CatalogueBearing> like = draft.row ? draft.row : row_named(draft.name);
  const auto note = [&](std::string_view key, bool says_something) {
    if (says_something && s.find(key) &&
        std::find(written_.begin(), written_.end(), key) == written_.end())
      written_.emplace_back(key);
  };
  const BearingGeometry& g = draft.geometry;
  const BearingGeometry none, &usual = like ? like->geometry : none;
  note("ball_count", g.ball_count != usual.ball_count);
  for (const auto& [key, number, unit] : lengths_and_ratios)
    // Written with ten digits.
    note(key, !(std::abs(g.*number - usual.*number) <= 1e-9 * std::abs(usual.*number)));
  for (const char* key : {"ball_material", "ring_material"})
    note(key, s.text(key).value_or("steel") != "steel");
}

void BearingReader::take_catalogue_row(const Section& s, const NamedBearing* base, Draft& draft) {
  const auto catalogue = s.text("catalogue");
  if (!catalogue) return;
  draft.from_catalogue = true;
  const auto rows = read_catalogues();
  NamedRow named;
  try {
    named = bearing_called(*catalogue, rows);
  } catch (const text::InputError& error) {
    s.fail("catalogue", error.what());
  }
  draft.geometry = named.row.geometry;
  if (named.is_estimated) return take_estimate(s, *catalogue, named, draft);
  draft.row = named.row;
  draft.name = draft.catalogue = draft.row->full_name();
  // Makers rate bearings with ceramic balls lower.
  const auto balls = s.text("ball_material");
  const std::string material = balls ? *balls : base ? base->bearing.balls().name : "";
  const double rating = draft.row->static_load_rating_silicon_nitride;
  if (material == "silicon-nitride" && !std::isnan(rating))
    draft.geometry.static_load_rating = rating;
}

/// A bearing that no catalogue has: every number that the file does not say is noted.
void BearingReader::take_estimate(const Section& s, const std::string& designation,
                                  const NamedRow& named, Draft& draft) {
  draft.row.reset();
  draft.name = draft.catalogue = designation;
  draft.ceramic_balls = named.ceramic_balls;
  for (const auto& [key, value] : keys_of(named.row.geometry))
    if (!s.find(key))
      tables_.note_default(
          s.name(), key, fmt::format("{:.6g}", value),
          key != "contact_angle_deg" ? "estimated, because the bearing is not in the catalogue"
          : named.states_angle       ? "from the designation"
                                     : "assumed, because the designation has no contact angle");
}

void BearingReader::read_geometry(const Section& s, Draft& draft) {
  BearingGeometry& g = draft.geometry;
  const auto take = [&](std::string_view key, double unit, double& value) {
    if (!s.take(key, value, unit) && std::isnan(value)) s.fail_missing(key);
  };
  if (const auto balls = s.whole_number("ball_count"))
    g.ball_count = *balls;
  else if (g.ball_count == 0)
    s.fail_missing("ball_count");
  take("ball_diameter_mm", mm, g.ball_diameter);
  take("pitch_diameter_mm", mm, g.pitch_diameter);
  take("contact_angle_deg", degree, g.contact_angle);
  for (const char* key : {"inner_conformity", "outer_conformity"})
    if (draft.from_catalogue && draft.row && !s.find(key))
      tables_.note_default(s.name(), key, fmt::format("{}", g.inner_conformity));
  take("inner_conformity", 1.0, g.inner_conformity);
  take("outer_conformity", 1.0, g.outer_conformity);
  s.take("static_load_rating_N", g.static_load_rating);
  s.take("radial_clearance_um", g.radial_clearance, um);
  refuse_other_units(s, g);
}

/// Bore, outer diameter and shoulders, and whether the bearing can be.
void BearingReader::read_envelope(const Section& s, BearingGeometry& g) {
  // A bore from the catalogue is no more that of a bearing with another pitch circle.
  if (s.find("ball_diameter_mm") || s.find("pitch_diameter_mm")) g.bore = g.outer_diameter = unset;
  s.take("bore_mm", g.bore, mm);
  s.take("outer_diameter_mm", g.outer_diameter, mm);
  s.take("inner_shoulder_diameter_mm", g.inner_shoulder_diameter, mm);
  s.take("outer_shoulder_diameter_mm", g.outer_shoulder_diameter, mm);
  const bool no_bore = std::isnan(g.bore), no_outer_diameter = std::isnan(g.outer_diameter);
  try {
    g = bearing::validated(g);
  } catch (const std::invalid_argument& error) {
    s.fail(error);
  }
  if (no_bore) tables_.note_default(s, "bore_mm", fmt::format("{:.6g}", g.bore / mm));
  if (no_outer_diameter)
    tables_.note_default(s, "outer_diameter_mm", fmt::format("{:.6g}", g.outer_diameter / mm));
}

Material BearingReader::material(const Section& s, const char* key, const Material* inherited) {
  if (inherited && !s.find(key)) return *inherited;
  Names names;
  for (const Material& known : materials_) names.push_back(known.name);
  return *find_material(tables_.choice(s, key, names));
}

}  // namespace raceway::files
