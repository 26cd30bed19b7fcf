#include <algorithm>
#include <array>
#include <cmath>

#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/spindle_parts.h"

namespace raceway::files {
namespace {

using model::Segment;
using model::SolidMaterial;

/// A number of a solid, its key and the unit of the key. The ranges hold steel, aluminium, ceramics
/// and carbon fibre.
struct SolidNumber {
  Key key;
  double SolidMaterial::*number;
  double unit = 1.0;
};
constexpr std::array solid_numbers{
    SolidNumber{
        {"conductivity_W_mK", between(0.05, 2000, "W/(m K)"), unset, "thermal conductivity"},
        &SolidMaterial::conductivity},
    SolidNumber{{"thermal_expansion_1e6_K", between(0, 50, "1e-6/K"), unset,
                 "linear thermal expansion of the material"},
                &SolidMaterial::thermal_expansion,
                per_million_K},
    SolidNumber{{"density_kg_m3", between(500, 20000, "kg/m3"), unset, "density of the material"},
                &SolidMaterial::density},
    SolidNumber{{"heat_capacity_J_kgK", between(50, 5000, "J/(kg K)"), unset,
                 "specific heat capacity of the material"},
                &SolidMaterial::heat_capacity},
    SolidNumber{{"elastic_modulus_GPa", between(1, 1200, "GPa"), unset, "Young's modulus"},
                &SolidMaterial::elastic_modulus,
                GPa},
    SolidNumber{{"poisson_ratio", between(0, 0.49), unset, "Poisson's ratio of the material"},
                &SolidMaterial::poissons_ratio}};

/// The same with the defaults of one material.
std::array<Key, solid_numbers.size()> solid_keys(const SolidMaterial& usual) {
  std::array<Key, solid_numbers.size()> keys;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto& [key, number, unit] = solid_numbers[k];
    keys[k] = key;
    keys[k].fallback = usual.*number / unit;
  }
  return keys;
}
const std::array shaft_solid_keys = solid_keys(model::steel_of_shafts);
const std::array housing_solid_keys = solid_keys(model::iron_of_housings);

constexpr Key shaft_keys[]{
    {"bore_mm", between(0, 5000, "mm"), 0.0, "bore of all segments without a bore_mm"},
    {"segment", a_list, is_required,
     "segments of the shaft from the nose to the rear, [[shaft.segment]]"},
    {"disk", a_list, unset, "masses on the shaft, [[shaft.disk]]"},
    {"roller_bearing", a_list, unset,
     "cylindrical roller bearings in addition to the sets, axially free, [[shaft.roller_bearing]]"},
    {"support", a_list, unset, "supports for which only a stiffness is known, [[shaft.support]]"},
};
constexpr Key shaft_segment_keys[]{
    {"length_mm", a_length, is_required, "length of the segment along the shaft"},
    {"diameter_mm", between(0.1, 5000, "mm"), is_required, "outer diameter"},
    {"bore_mm", between(0, 5000, "mm"), "bore_mm of [shaft]", "bore of this segment"},
    {"material", a_text, "material data of [shaft]",
     "material: \"steel\", \"cast-iron\" or a table [material.NAME] with all material data of "
     "[shaft]"},
};
constexpr Key shaft_disk_keys[]{
    {"position_mm", anywhere, is_required, "distance of the disk behind the nose face"},
    {"mass_kg", between(0, 1e5, "kg"), is_required, "mass of the disk"},
    {"diametral_inertia_kgm2", between(0, 1e5, "kg m2"), is_required,
     "moment of inertia about a diameter"},
    {"polar_inertia_kgm2", between(0, 1e5, "kg m2"), is_required,
     "moment of inertia about the axis"},
};
constexpr Key shaft_support_keys[]{
    {"position_mm", on_the_shaft, is_required, "distance of the support behind the nose face"},
    {"radial_N_um", between(0, 1e6, "N/um"), is_required, "radial stiffness"},
    {"tilt_Nm_rad", between(0, 1e12, "N m/rad"), 0.0, "stiffness against tilt"},
};

const model::Housing usual_housing;
const Key housing_keys[]{
    {"start_mm", anywhere, is_required,
     "distance of the front face of the housing behind the nose face"},
    {"length_mm", a_length, is_required, "length of a housing of one piece"},
    {"outer_diameter_mm", between(1, 10000, "mm"), is_required,
     "outer diameter of a housing of one piece; its bore is the outer diameter of the bearings"},
    {"segment", a_list, unset,
     "segments of the housing, instead of length_mm and outer_diameter_mm, [[housing.segment]]"},
    {"flange_mm", anywhere, is_required,
     "distance of the middle of the mounting flange behind the nose face"},
    {"flange_length_mm", between(0.1, longest_mm, "mm"), usual_housing.flange_length / mm,
     "axial length of the flange"},
    {"flange_conductance_W_K", between(0, 1e4, "W/K"), usual_housing.flange_conductance,
     "thermal conductance from the flange to the machine; with flange_screws, the conductance of "
     "the screwed joint is added in series"},
    {"flange_screws", whole(1, 1000), unset,
     "number of flange screws; the conductance of the joint then follows from their force"},
    {"flange_screw_force_N", between(1, 1e7, "N"), unset, "clamping force of one screw"},
    {"flange_contact_mm2", between(1, 1e8, "mm2"), unset, "contact area of the flange"},
};
constexpr Key housing_segment_keys[]{
    {"length_mm", a_length, is_required, "length of the segment along the spindle"},
    {"outer_diameter_mm", between(1, 10000, "mm"), unset,
     "outer diameter; give outer_diameter_mm or diameter_mm"},
    {"diameter_mm", between(1, 10000, "mm"), unset, "another name of outer_diameter_mm"},
    {"bore_mm", between(0, 5000, "mm"), "the outer diameter of the bearings",
     "bore of this segment"},
    {"material", a_text, "material data of [housing]",
     "material: \"steel\", \"cast-iron\" or a table [material.NAME] with all material data of "
     "[housing]"},
};

constexpr model::Seat usual_seat;
constexpr Key seat_keys[]{
    {"inner_interference_um", between(-500, 500, "um"), usual_seat.inner_interference / um,
     "diametral interference of the inner rings on the shaft"},
    {"outer_clearance_um", between(-500, 500, "um"), usual_seat.outer_clearance / um,
     "diametral clearance of the outer rings in the housing"},
    {"roughness_um", between(0.01, 50, "um"), usual_seat.roughness / um,
     "roughness of the contact surfaces"},
    {"slope", between(0.001, 2), usual_seat.slope, "mean absolute slope of the roughness profile"},
    {"hardness_GPa", between(0.05, 100, "GPa"), usual_seat.hardness / GPa,
     "hardness of the softer surface"},
    {"shoulder_conductance_W_m2K", between(0, 1e6, "W/(m2 K)"), usual_seat.shoulder_conductance,
     "contact conductance of the shoulders at the rings, if no clamping force is given"},
    {"collar_conductance_W_m2K", between(0, 1e6, "W/(m2 K)"), usual_seat.collar_conductance,
     "conductance of the gap between the outer ring and a rotating collar of the shaft; about 270 "
     "for an open gap of 0.1 mm"},
    {"inner_clamping_force_N", between(1, 1e7, "N"), unset,
     "force of the shaft nut on inner rings and spacers; the contact conductance of their side "
     "faces then follows from the pressure"},
    {"outer_clamping_force_N", between(1, 1e7, "N"), unset,
     "force of the cover on the outer rings; the contact conductance of their side faces then "
     "follows from the pressure"},
    {"outer_conductance_W_m2K", between(0.1, 1e6, "W/(m2 K)"),
     "calculated from the fit of the seat", "contact conductance of the outer seats"},
};

constexpr Key gap_keys[]{
    {"inner_diameter_mm", between(0.1, 10000, "mm"), unset,
     "inner diameter of an air gap between shaft and housing; without the table [gap], the gap "
     "lies between the sets"},
    {"outer_diameter_mm", between(0.1, 10000, "mm"), unset, "outer diameter of the gap"},
    {"start_mm", on_the_shaft, unset, "distance of the start of the gap behind the nose face"},
    {"end_mm", on_the_shaft, unset, "distance of the end of the gap behind the nose face"},
};

/// Material of a table; numbers that the table leaves out have defaults.
SolidMaterial read_solid(ModelTables& tables, const Section& s) {
  SolidMaterial solid;
  for (const auto& [key, number, unit] : solid_numbers)
    solid.*number = tables.number(s, key.name) * unit;
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
  const Section m = Section(tables.source(), "material." + *name, table->get(*name)->as_table())
                        .part({shaft_solid_keys});
  SolidMaterial solid;
  for (const auto& [key, number, unit] : solid_numbers) {
    const auto value = m.number(key.name);
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
  const auto a = s.number("outer_diameter_mm"), b = s.number("diameter_mm");
  if (a && b)
    s.fail("diameter_mm", "diameter_mm and outer_diameter_mm are the same quantity; remove one");
  if (!a && !b) s.fail_missing("outer_diameter_mm");
  return (a ? *a : *b) * mm;
}

std::vector<Segment> read_housing_segments(const ModelTables& tables, const Section& s,
                                           const SolidMaterial& material) {
  std::vector<Segment> list;
  for (const Section& one : tables_in(s, "segment", {housing_segment_keys})) {
    Segment segment{.length = one.required("length_mm") * mm,
                    .diameter = outer_diameter_of(one),
                    .bore = unset,
                    .material = material_of(tables, one, material)};
    one.take("bore_mm", segment.bore, mm);
    require_wall(one, segment);
    list.push_back(segment);
  }
  return list;
}

std::vector<model::Disk> read_disks(const Section& s) {
  std::vector<model::Disk> list;
  for (const Section& one : tables_in(s, "disk", {shaft_disk_keys})) {
    list.push_back({.position = one.required("position_mm") * mm,
                    .mass = one.required("mass_kg"),
                    .diametral_inertia = one.required("diametral_inertia_kgm2"),
                    .polar_inertia = one.required("polar_inertia_kgm2")});
    // Of a thin disk; a longer body has more about its diameter, none less than half.
    if (list.back().polar_inertia > 2.0 * list.back().diametral_inertia * (1.0 + 1e-9))
      one.fail("polar_inertia_kgm2",
               fmt::format("polar_inertia_kgm2 = {:.6g} kg m2: must be at most twice "
                           "diametral_inertia_kgm2 = {:.6g} kg m2",
                           list.back().polar_inertia, list.back().diametral_inertia));
  }
  return list;
}

std::vector<model::Support> read_supports(ModelTables& tables, const Section& s) {
  std::vector<model::Support> list;
  for (const Section& one : tables_in(s, "support", {shaft_support_keys}))
    list.push_back({.position = one.required("position_mm") * mm,
                    .radial_stiffness = one.required("radial_N_um") * N_per_um,
                    .tilt_stiffness = tables.number(one, "tilt_Nm_rad")});
  return list;
}

std::optional<model::ScrewedJoint> read_flange_joint(const Section& s) {
  constexpr std::array keys{"flange_screws", "flange_screw_force_N", "flange_contact_mm2"};
  const auto given = [&](const char* key) { return s.find(key) != nullptr; };
  if (std::none_of(keys.begin(), keys.end(), given)) return std::nullopt;
  if (!given(keys[0])) s.fail_missing(keys[0]);
  return model::ScrewedJoint{.screws = *s.whole_number(keys[0]),
                             .screw_force = s.required(keys[1]),
                             .area = s.required(keys[2]) * mm * mm};
}

}  // namespace

std::vector<KeyTable> body_tables() {
  return {{"shaft", shaft_keys},
          {"shaft", shaft_solid_keys},
          {"shaft.segment", shaft_segment_keys},
          {"shaft.disk", shaft_disk_keys},
          {"shaft.support", shaft_support_keys},
          {"housing", housing_keys},
          {"housing", housing_solid_keys},
          {"housing.segment", housing_segment_keys},
          {"seat", seat_keys},
          {"gap", gap_keys}};
}

double expansion_of(const ModelTables& tables, std::string_view table, double fallback) {
  const auto value = tables.part(table, {shaft_solid_keys}).number("thermal_expansion_1e6_K");
  return value ? *value * per_million_K : fallback;
}

std::vector<Section> tables_in(const Section& s, std::string_view key, const Keys& keys) {
  const toml::node* const node = s.find(key);
  if (!node) return {};
  const std::string name =
      s.name().empty() ? std::string(key) : fmt::format("{}.{}", s.name(), key);
  if (!node->is_array() || (!node->as_array()->empty() && !node->is_array_of_tables()))
    s.fail(key, fmt::format("{} = {}: must be a list of tables, written as [[{}]]", key,
                            text::shown(*node), name));
  std::vector<Section> list;
  for (const toml::node& one : *node->as_array())
    list.emplace_back(s.source(), name, one.as_table(), keys);
  return list;
}

std::vector<Section> sensor_sections(const ModelTables& tables, const Keys& keys) {
  return tables_in(Section(tables.source(), "", &tables.root()), "sensor", keys);
}

std::vector<Section> heat_sections(const ModelTables& tables, const Keys& keys) {
  return tables_in(Section(tables.source(), "", &tables.root()), "heat", keys);
}

model::ShaftBody read_shaft_body(ModelTables& tables) {
  const Section s = tables.section("shaft", {shaft_keys, shaft_solid_keys});
  const SolidMaterial material = read_solid(tables, s);
  const double bore = tables.number(s, "bore_mm") * mm;
  model::ShaftBody body;
  for (const Section& one : tables_in(s, "segment", {shaft_segment_keys})) {
    Segment segment{.length = one.required("length_mm") * mm,
                    .diameter = one.required("diameter_mm") * mm,
                    .bore = bore,
                    .material = material_of(tables, one, material)};
    one.take("bore_mm", segment.bore, mm);
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
  const Section s = tables.section("housing", {housing_keys, housing_solid_keys});
  model::Housing housing;
  housing.start = s.required("start_mm") * mm;
  const SolidMaterial material = read_solid(tables, s);
  if (s.find("segment")) {
    for (const char* key : {"length_mm", "outer_diameter_mm"})
      if (s.find(key))
        s.fail(key, fmt::format("{} = {}: not possible together with segments of [housing], which "
                                "already give this dimension; remove the key or the segments",
                                key, text::shown(*s.find(key))));
    housing.segments = read_housing_segments(tables, s, material);
    if (housing.segments.empty())
      s.fail("segment", "segment = []: a housing needs at least one segment");
  } else {
    housing.segments.push_back({.length = s.required("length_mm") * mm,
                                .diameter = s.required("outer_diameter_mm") * mm,
                                .bore = unset,
                                .material = material});
  }
  housing.flange = s.required("flange_mm") * mm;
  housing.flange_length = tables.number(s, "flange_length_mm") * mm;
  housing.flange_conductance = tables.number(s, "flange_conductance_W_K");
  housing.flange_joint = read_flange_joint(s);
  return housing;
}

model::Seat read_seat(ModelTables& tables) {
  const Section s = tables.section("seat", {seat_keys});
  model::Seat seat;
  seat.inner_interference = tables.number(s, "inner_interference_um") * um;
  seat.outer_clearance = tables.number(s, "outer_clearance_um") * um;
  seat.roughness = tables.number(s, "roughness_um") * um;
  seat.slope = tables.number(s, "slope");
  seat.hardness = tables.number(s, "hardness_GPa") * GPa;
  seat.shoulder_conductance = tables.number(s, "shoulder_conductance_W_m2K");
  seat.collar_conductance = tables.number(s, "collar_conductance_W_m2K");
  s.take("inner_clamping_force_N", seat.inner_clamping_force);
  s.take("outer_clamping_force_N", seat.outer_clamping_force);
  s.take("outer_conductance_W_m2K", seat.outer_conductance);
  return seat;
}

std::optional<model::Gap> read_gap(const ModelTables& tables) {
  const Section s = tables.section("gap", {gap_keys});
  if (!s.given()) return std::nullopt;
  model::Gap gap;
  s.take("inner_diameter_mm", gap.inner_diameter, mm);
  s.take("outer_diameter_mm", gap.outer_diameter, mm);
  s.take("start_mm", gap.start, mm);
  s.take("end_mm", gap.end, mm);
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

}  // namespace raceway::files
