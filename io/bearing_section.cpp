#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "io/number_text.h"
#include "record/units.h"

// Last: see io/toml_text.h.
#include "io/bearing_section.h"

namespace raceway::io {
namespace {

using bearing::BearingGeometry;
using bearing::Material;

// Wherever the libraries check as well, these are their ranges.
constexpr Key ball_count{"ball_count", "", 3, 200};
constexpr Key ball_diameter{"ball_diameter_mm", "mm", 0.1, 300};
constexpr Key pitch_diameter{"pitch_diameter_mm", "mm", 1, 5000};
constexpr Key contact_angle{"contact_angle_deg", "deg", 0, 65};
constexpr Key inner_conformity{"inner_conformity", "", 0.5005, 0.7};
constexpr Key outer_conformity{"outer_conformity", "", 0.5005, 0.7};
constexpr Key bore{"bore_mm", "mm", 0, 5000};
constexpr Key outer_diameter{"outer_diameter_mm", "mm", 1, 10000};
constexpr Key radial_clearance{"radial_clearance_um", "um", 0, 10000};
constexpr Key inner_shoulder{"inner_shoulder_diameter_mm", "mm", 0.1, 5000};
constexpr Key outer_shoulder{"outer_shoulder_diameter_mm", "mm", 1, 10000};
constexpr Key elastic_modulus{"elastic_modulus_GPa", "GPa", 1, 1200};
constexpr Key poisson_ratio{"poisson_ratio", "", 0, 0.49};
constexpr Key density{"density_kg_m3", "kg/m3", 500, 20000};
constexpr Key thermal_expansion{"thermal_expansion_1e6_K", "1e-6/K", 0, 50};

/// Of what a segment of a spindle may be made of; balls and rings need neither.
constexpr std::array heat_of_solids{Key{"conductivity_W_mK", "W/(m K)", 0.05, 2000},
                                    Key{"heat_capacity_J_kgK", "J/(kg K)", 50, 5000}};

template <std::size_t count>
Names names_of(const std::array<Key, count>& keys) {
  Names names;
  for (const Key& key : keys) names.emplace_back(key.name);
  return names;
}

Names keys_of_a_bearing(const Names& further) {
  Names known{"name", "catalogue"};
  const Names numbers =
      names_of(std::array{ball_count, ball_diameter, pitch_diameter, contact_angle,
                          inner_conformity, outer_conformity, static_load_rating});
  known.insert(known.end(), numbers.begin(), numbers.end());
  known.insert(known.end(), {"ball_material", "ring_material"});
  const Names envelope =
      names_of(std::array{bore, outer_diameter, radial_clearance, inner_shoulder, outer_shoulder});
  known.insert(known.end(), envelope.begin(), envelope.end());
  known.insert(known.end(), further.begin(), further.end());
  return known;
}

/// Numbers of a bearing that may be left to the catalogue.
struct GeometryNumber {
  Key key;
  double BearingGeometry::*number;
};
constexpr std::array lengths_and_ratios{
    GeometryNumber{ball_diameter, &BearingGeometry::ball_diameter},
    GeometryNumber{pitch_diameter, &BearingGeometry::pitch_diameter},
    GeometryNumber{contact_angle, &BearingGeometry::contact_angle},
    GeometryNumber{inner_conformity, &BearingGeometry::inner_conformity},
    GeometryNumber{outer_conformity, &BearingGeometry::outer_conformity},
    GeometryNumber{static_load_rating, &BearingGeometry::static_load_rating},
    GeometryNumber{bore, &BearingGeometry::bore},
    GeometryNumber{outer_diameter, &BearingGeometry::outer_diameter},
    GeometryNumber{radial_clearance, &BearingGeometry::radial_clearance}};

/// The bearing of the catalogue with that very name; none without a catalogue.
std::optional<CatalogueBearing> row_named(const std::string& name) {
  try {
    for (const CatalogueBearing& row : read_catalogues())
      if (row.full_name() == name) return row;
  } catch (const InputError&) {
    // Whoever needs the catalogue is told so.
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::pair<std::string, double>> keys_of(const BearingGeometry& geometry) {
  std::vector<std::pair<std::string, double>> keys{
      {std::string(ball_count.name), static_cast<double>(geometry.ball_count)}};
  for (const auto& [key, number] : lengths_and_ratios) {
    const double unit = key.unit == "mm"    ? mm
                        : key.unit == "deg" ? degree
                        : key.unit == "um"  ? um
                                            : 1.0;
    if (!std::isnan(geometry.*number))
      keys.emplace_back(key.name, with_15_digits(geometry.*number / unit));
  }
  return keys;
}

Names missing_keys_of_bearing(const ModelTables& tables) {
  const Section s = tables.section("bearing");
  if (s.find("catalogue")) return {};
  return s.lacking({ball_count, ball_diameter, pitch_diameter, contact_angle, inner_conformity,
                    outer_conformity});
}

/// A bearing in the making.
struct BearingReader::Draft {
  BearingGeometry geometry;
  std::string name;
  std::optional<CatalogueBearing> row;
  bool from_catalogue = false;  ///< by this table
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
    throw InputError(fmt::format("{}: {} = {}: materials are tables, written as [material.NAME]",
                                 place, name, shown(node)),
                     tables_.at(key));
  if (find_material(name))
    throw InputError(
        fmt::format("{}: [material.{}]: this name is built in; take another", place, name),
        tables_.at(key));
  const Section s(tables_.source(), "material." + name, node.as_table());
  const Names known =
      names_of(std::array{elastic_modulus, poisson_ratio, density, thermal_expansion});
  Names with_heat = known;
  for (const std::string& name_of_heat : names_of(heat_of_solids))
    with_heat.push_back(name_of_heat);
  s.allow_only(with_heat);
  for (const Key& heat : heat_of_solids) (void)s.number(heat);
  const Material material{.name = name,
                          .elastic_modulus = s.required(elastic_modulus) * GPa,
                          .poisson_ratio = s.required(poisson_ratio),
                          .density = s.required(density),
                          .thermal_expansion = s.required(thermal_expansion) * per_million_K};
  try {
    bearing::validate(material);
  } catch (const std::invalid_argument& error) {
    s.fail(error, known);
  }
  materials_.push_back(material);
}

const Material* BearingReader::find_material(std::string_view name) const {
  for (const Material& material : materials_)
    if (material.name == name) return &material;
  return nullptr;
}

NamedBearing BearingReader::read(const Section& s, const NamedBearing* base, const Names& further) {
  const Names known = keys_of_a_bearing(further);
  s.allow_only(known);
  Draft draft;
  if (base) {
    draft.geometry = base->bearing.geometry();
    draft.row = base->row;
    draft.name = base->name;
  }
  take_catalogue_row(s, base, draft);
  read_geometry(s, draft);
  read_envelope(s, known, draft.geometry);
  const Material balls = material(s, "ball_material", base ? &base->bearing.balls() : nullptr);
  const Material rings = material(s, "ring_material", base ? &base->bearing.rings() : nullptr);
  if (auto given = s.text("name")) draft.name = *given;
  note_written(s, draft);
  if (draft.name.empty()) {
    draft.name = std::filesystem::path(tables_.source()).stem().string();
    tables_.note_default("bearing", "name", fmt::format("\"{}\"", draft.name));
  }
  return {bearing::Bearing(draft.geometry, balls, rings), draft.name, draft.row};
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
  note(ball_count.name, g.ball_count != usual.ball_count);
  for (const auto& [key, number] : lengths_and_ratios)
    // Written with ten digits.
    note(key.name, !(std::abs(g.*number - usual.*number) <= 1e-9 * std::abs(usual.*number)));
  for (const char* key : {"ball_material", "ring_material"})
    note(key, s.text(key).value_or("steel") != "steel");
}

void BearingReader::take_catalogue_row(const Section& s, const NamedBearing* base,
                                       Draft& draft) const {
  const auto catalogue = s.text("catalogue");
  if (!catalogue) return;
  draft.from_catalogue = true;
  const auto rows = read_catalogues();
  try {
    draft.row = find_bearing(rows, *catalogue);
  } catch (const InputError& error) {
    s.fail("catalogue", error.what());
  }
  draft.geometry = draft.row->geometry;
  draft.name = draft.row->full_name();
  // Makers rate bearings with ceramic balls lower.
  const auto balls = s.text("ball_material");
  const std::string material = balls ? *balls : base ? base->bearing.balls().name : "";
  const double rating = draft.row->static_load_rating_silicon_nitride;
  if (material == "silicon-nitride" && !std::isnan(rating))
    draft.geometry.static_load_rating = rating;
}

void BearingReader::read_geometry(const Section& s, Draft& draft) {
  BearingGeometry& g = draft.geometry;
  const auto take = [&](const Key& key, double unit, double& value) {
    if (const auto given = s.number(key))
      value = *given * unit;
    else if (std::isnan(value))
      s.fail_missing(key);
  };
  if (const auto balls = s.whole_number(ball_count))
    g.ball_count = *balls;
  else if (g.ball_count == 0)
    s.fail_missing(ball_count);
  take(ball_diameter, mm, g.ball_diameter);
  take(pitch_diameter, mm, g.pitch_diameter);
  take(contact_angle, degree, g.contact_angle);
  for (const Key& key : {inner_conformity, outer_conformity})
    if (draft.from_catalogue && !s.find(key.name))
      tables_.note_default(s.name(), key.name, fmt::format("{}", g.inner_conformity));
  take(inner_conformity, 1.0, g.inner_conformity);
  take(outer_conformity, 1.0, g.outer_conformity);
  if (const auto given = s.number(static_load_rating)) g.static_load_rating = *given;
  if (const auto given = s.number(radial_clearance)) g.radial_clearance = *given * um;
}

/// Bore, outer diameter and shoulders, and whether the bearing can be.
void BearingReader::read_envelope(const Section& s, const Names& known, BearingGeometry& g) {
  // A bore from the catalogue is no more that of a bearing with another pitch circle.
  if (s.find(ball_diameter.name) || s.find(pitch_diameter.name)) g.bore = g.outer_diameter = unset;
  if (const auto given = s.number(bore)) g.bore = *given * mm;
  if (const auto given = s.number(outer_diameter)) g.outer_diameter = *given * mm;
  if (const auto given = s.number(inner_shoulder)) g.inner_shoulder_diameter = *given * mm;
  if (const auto given = s.number(outer_shoulder)) g.outer_shoulder_diameter = *given * mm;
  const bool no_bore = std::isnan(g.bore), no_outer_diameter = std::isnan(g.outer_diameter);
  try {
    g = bearing::validated(g);
  } catch (const std::invalid_argument& error) {
    s.fail(error, known);
  }
  if (no_bore)
    tables_.note_default(s.name(), bore.name, fmt::format("{:.6g}", g.bore / mm),
                         "default: pitch diameter - 1.5 ball diameters");
  if (no_outer_diameter)
    tables_.note_default(s.name(), outer_diameter.name,
                         fmt::format("{:.6g}", g.outer_diameter / mm),
                         "default: pitch diameter + 1.5 ball diameters");
}

Material BearingReader::material(const Section& s, const char* key, const Material* inherited) {
  if (inherited && !s.find(key)) return *inherited;
  Names names;
  for (const Material& known : materials_) names.push_back(known.name);
  return *find_material(tables_.choice_or(s, key, names, "steel"));
}

}  // namespace raceway::io
