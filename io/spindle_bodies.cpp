#include <algorithm>
#include <cmath>

#include "record/units.h"

// Last: see io/toml_text.h.
#include "io/spindle_parts.h"

namespace raceway::io {
namespace {

using model::Segment;
using model::SolidMaterial;

/// A key of a solid, and its number. The ranges hold steel, aluminium, ceramics and carbon fibre.
struct SolidNumber {
  Key key;
  double SolidMaterial::*number;
  double unit;
};
constexpr std::array solid_numbers{
    SolidNumber{{"conductivity_W_mK", "W/(m K)", 0.05, 2000}, &SolidMaterial::conductivity, 1.0},
    SolidNumber{{"thermal_expansion_1e6_K", "1e-6/K", 0, 50},
                &SolidMaterial::thermal_expansion,
                per_million_K},
    SolidNumber{{"density_kg_m3", "kg/m3", 500, 20000}, &SolidMaterial::density, 1.0},
    SolidNumber{{"heat_capacity_J_kgK", "J/(kg K)", 50, 5000}, &SolidMaterial::heat_capacity, 1.0},
    SolidNumber{{"elastic_modulus_GPa", "GPa", 1, 1200}, &SolidMaterial::elastic_modulus, GPa},
    SolidNumber{{"poisson_ratio", "", 0, 0.49}, &SolidMaterial::poissons_ratio, 1.0}};

constexpr Key segment_length{"length_mm", "mm", 0.001, longest_mm};
constexpr Key segment_bore{"bore_mm", "mm", 0, 5000};

Names with_solid_keys(Names names) {
  for (const SolidNumber& n : solid_numbers) names.emplace_back(n.key.name);
  return names;
}

/// What a table says of its material, the rest as `usual`.
SolidMaterial read_solid(ModelTables& tables, const Section& s, const SolidMaterial& usual) {
  SolidMaterial solid = usual;
  for (const auto& [key, number, unit] : solid_numbers)
    solid.*number = tables.number_or(s, key, usual.*number / unit) * unit;
  return solid;
}

/// The material that a segment names: built in, or a table [material.NAME] that knows heat too.
SolidMaterial material_of(const ModelTables& tables, const Section& s,
                          const SolidMaterial& inherited) {
  const auto name = s.text("material");
  if (!name) return inherited;
  if (*name == "steel") return model::steel_of_shafts;
  if (*name == "cast-iron") return model::iron_of_housings;
  Names known{"steel", "cast-iron"};
  const toml::table* const table = tables.root()["material"].as_table();
  if (table)
    for (const auto& [key, node] : *table) known.emplace_back(key.str());
  (void)s.choice("material", known);
  const Section m(tables.source(), "material." + *name, table->get(*name)->as_table());
  SolidMaterial solid;
  for (const auto& [key, number, unit] : solid_numbers) {
    const auto value = m.number(key);
    if (!value) m.fail_missing(key, fmt::format(", which [{}] needs", s.name()));
    solid.*number = *value * unit;
  }
  return solid;
}

void require_wall(const Section& s, const Segment& segment) {
  if (segment.bore >= segment.diameter)
    s.fail("bore_mm", fmt::format("bore_mm = {:.10g} mm: must be below the diameter, {:.10g} mm",
                                  segment.bore / mm, segment.diameter / mm));
}

/// A housing's outer diameter, by either of the names that it has in the file.
double outer_diameter_of(const Section& s) {
  const Key outer{"outer_diameter_mm", "mm", 1, 10000}, plain{"diameter_mm", "mm", 1, 10000};
  const auto a = s.number(outer), b = s.number(plain);
  if (a && b) s.fail(plain.name, "diameter_mm: outer_diameter_mm says it too; take one");
  if (!a && !b) s.fail_missing(outer);
  return (a ? *a : *b) * mm;
}

std::vector<Segment> read_housing_segments(const ModelTables& tables, const Section& s,
                                           const SolidMaterial& material) {
  std::vector<Segment> list;
  for (const Section& one : tables_in(s, "segment")) {
    one.allow_only({"length_mm", "outer_diameter_mm", "diameter_mm", "bore_mm", "material"});
    Segment segment{.length = one.required(segment_length) * mm,
                    .diameter = outer_diameter_of(one),
                    .bore = unset,
                    .material = material_of(tables, one, material)};
    if (const auto bore = one.number(segment_bore)) segment.bore = *bore * mm;
    require_wall(one, segment);
    list.push_back(segment);
  }
  return list;
}

std::vector<model::Disk> read_disks(const Section& s) {
  std::vector<model::Disk> list;
  for (const Section& one : tables_in(s, "disk")) {
    const Key position{"position_mm", "mm", -longest_mm, longest_mm}, mass{"mass_kg", "kg", 0, 1e5},
        diametral{"diametral_inertia_kgm2", "kg m2", 0, 1e5},
        polar{"polar_inertia_kgm2", "kg m2", 0, 1e5};
    one.allow_only({"position_mm", "mass_kg", "diametral_inertia_kgm2", "polar_inertia_kgm2"});
    list.push_back({.position = one.required(position) * mm,
                    .mass = one.required(mass),
                    .diametral_inertia = one.required(diametral),
                    .polar_inertia = one.required(polar)});
    // Of a thin disk; a longer body has more about its diameter, none less than half.
    if (list.back().polar_inertia > 2.0 * list.back().diametral_inertia * (1.0 + 1e-9))
      one.fail(polar.name,
               fmt::format("polar_inertia_kgm2 = {:.6g} kg m2: no body has more than twice its "
                           "diametral_inertia_kgm2 = {:.6g} kg m2",
                           list.back().polar_inertia, list.back().diametral_inertia));
  }
  return list;
}

std::vector<model::Support> read_supports(ModelTables& tables, const Section& s) {
  std::vector<model::Support> list;
  for (const Section& one : tables_in(s, "support")) {
    one.allow_only({"position_mm", "radial_N_um", "tilt_Nm_rad"});
    list.push_back(
        {.position = one.required({"position_mm", "mm", 0, longest_mm}) * mm,
         .radial_stiffness = one.required({"radial_N_um", "N/um", 0, 1e6}) * N_per_um,
         .tilt_stiffness = tables.number_or(one, {"tilt_Nm_rad", "N m/rad", 0, 1e12}, 0.0)});
  }
  return list;
}

}  // namespace

std::vector<Section> tables_in(const Section& s, std::string_view key) {
  const toml::node* const node = s.find(key);
  if (!node) return {};
  const std::string name =
      s.name().empty() ? std::string(key) : fmt::format("{}.{}", s.name(), key);
  if (!node->is_array() || (!node->as_array()->empty() && !node->is_array_of_tables()))
    s.fail(key, fmt::format("{} = {}: must be a list of tables, written as [[{}]]", key,
                            shown(*node), name));
  std::vector<Section> list;
  for (const toml::node& one : *node->as_array())
    list.emplace_back(s.source(), name, one.as_table());
  return list;
}

model::ShaftBody read_shaft_body(ModelTables& tables) {
  const Section s = tables.section("shaft");
  s.allow_only(with_solid_keys({"bore_mm", "segment", "disk", "support"}));
  const SolidMaterial material = read_solid(tables, s, model::steel_of_shafts);
  const double bore = tables.number_or(s, segment_bore, 0.0) * mm;
  model::ShaftBody body;
  for (const Section& one : tables_in(s, "segment")) {
    one.allow_only({"length_mm", "diameter_mm", "bore_mm", "material"});
    Segment segment{.length = one.required(segment_length) * mm,
                    .diameter = one.required({"diameter_mm", "mm", 0.1, 5000}) * mm,
                    .bore = bore,
                    .material = material_of(tables, one, material)};
    if (const auto own = one.number(segment_bore)) segment.bore = *own * mm;
    require_wall(one, segment);
    body.segments.push_back(segment);
  }
  if (body.segments.empty())
    s.fail("segment",
           "[shaft] has no segment: give [[shaft.segment]] with length_mm and diameter_mm, from "
           "the nose to the rear");
  body.disks = read_disks(s);
  body.supports = read_supports(tables, s);
  return body;
}

model::Housing read_housing(ModelTables& tables) {
  const Section s = tables.section("housing");
  s.allow_only(with_solid_keys({"start_mm", "length_mm", "outer_diameter_mm", "segment",
                                "flange_mm", "flange_length_mm", "flange_conductance_W_K"}));
  model::Housing housing;
  housing.start = s.required({"start_mm", "mm", -longest_mm, longest_mm}) * mm;
  const SolidMaterial material = read_solid(tables, s, model::iron_of_housings);
  if (s.find("segment")) {
    for (const char* key : {"length_mm", "outer_diameter_mm"})
      if (s.find(key))
        s.fail(key, fmt::format("{} = {}: the segments of [housing] say it; take one", key,
                                shown(*s.find(key))));
    housing.segments = read_housing_segments(tables, s, material);
    if (housing.segments.empty()) s.fail("segment", "segment = []: a housing has one or more");
  } else {
    housing.segments.push_back({.length = s.required(segment_length) * mm,
                                .diameter = s.required({"outer_diameter_mm", "mm", 1, 10000}) * mm,
                                .bore = unset,
                                .material = material});
  }
  housing.flange = s.required({"flange_mm", "mm", -longest_mm, longest_mm}) * mm;
  housing.flange_length =
      tables.number_or(s, {"flange_length_mm", "mm", 0.1, longest_mm}, housing.flange_length / mm) *
      mm;
  housing.flange_conductance =
      tables.number_or(s, {"flange_conductance_W_K", "W/K", 0, 1e4}, housing.flange_conductance);
  return housing;
}

model::Seat read_seat(ModelTables& tables) {
  const Section s = tables.section("seat");
  const Key outer{"outer_conductance_W_m2K", "W/(m2 K)", 0.1, 1e6};
  s.allow_only({"inner_interference_um", "outer_clearance_um", "roughness_um", "slope",
                "hardness_GPa", "shoulder_conductance_W_m2K", "collar_conductance_W_m2K",
                std::string(outer.name)});
  model::Seat seat;
  const auto take = [&](double& value, const Key& key, double unit) {
    value = tables.number_or(s, key, value / unit) * unit;
  };
  take(seat.inner_interference, {"inner_interference_um", "um", -500, 500}, um);
  take(seat.outer_clearance, {"outer_clearance_um", "um", -500, 500}, um);
  take(seat.roughness, {"roughness_um", "um", 0.01, 50}, um);
  take(seat.slope, {"slope", "", 0.001, 2}, 1.0);
  take(seat.hardness, {"hardness_GPa", "GPa", 0.05, 100}, GPa);
  take(seat.shoulder_conductance, {"shoulder_conductance_W_m2K", "W/(m2 K)", 0, 1e6}, 1.0);
  take(seat.collar_conductance, {"collar_conductance_W_m2K", "W/(m2 K)", 0, 1e6}, 1.0);
  if (const auto value = s.number(outer)) seat.outer_conductance = *value;
  return seat;
}

std::optional<model::Gap> read_gap(const ModelTables& tables) {
  const Section s = tables.section("gap");
  if (!s.given()) return std::nullopt;
  s.allow_only({"inner_diameter_mm", "outer_diameter_mm", "start_mm", "end_mm"});
  model::Gap gap;
  const auto take = [&](double& value, const Key& key) {
    if (const auto given = s.number(key)) value = *given * mm;
  };
  take(gap.inner_diameter, {"inner_diameter_mm", "mm", 0.1, 10000});
  take(gap.outer_diameter, {"outer_diameter_mm", "mm", 0.1, 10000});
  take(gap.start, {"start_mm", "mm", 0, longest_mm});
  take(gap.end, {"end_mm", "mm", 0, longest_mm});
  if (gap.outer_diameter <= gap.inner_diameter)
    s.fail(
        "outer_diameter_mm",
        fmt::format("outer_diameter_mm = {:.10g} mm: must be above inner_diameter_mm = {:.10g} mm",
                    gap.outer_diameter / mm, gap.inner_diameter / mm));
  if (gap.end <= gap.start)
    s.fail("end_mm", fmt::format("end_mm = {:.10g} mm: must be above start_mm = {:.10g} mm",
                                 gap.end / mm, gap.start / mm));
  return gap;
}

}  // namespace raceway::io
