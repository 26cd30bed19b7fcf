#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "model/judgement.h"
#include "record/series_channel.h"
#include "record/units.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/spindle_parts.h"

namespace raceway::files {
namespace {

constexpr model::Ambient usual_air;
constexpr Key ambient_keys[]{
    {"temperature_C", between(-100, 200, "C"), celsius(usual_air.temperature),
     "temperature of the air"},
    {"machine_temperature_C", between(-100, 200, "C"), "temperature of the air",
     "temperature of the machine behind the flange"},
    {"emissivity", between(0, 1), usual_air.emissivity,
     "emissivity of the surfaces, for radiation"},
    {"convection_factor", between(0, 20), usual_air.convection_factor,
     "factor on the free convection of housing and end faces"},
    {"rotating_convection", one_of("becker|kendoush|anderson-saunders"), "becker",
     "author of the correlation for the convection of rotating surfaces"},
};

constexpr Key coolant_keys[]{
    {"fluid", one_of("water|oil"), "water", "fluid of the coolant circuit"},
    {"inlet_temperature_C", between(-50, 150, "C"), "temperature of the air",
     "coolant temperature at the inlet"},
    {"circuit", a_list, unset,
     "further coolant circuits around other parts of the housing, [[coolant.circuit]]"},
};
constexpr Key circuit_keys[]{
    {"name", a_text, is_required,
     "name of the circuit (letters, digits and _) in the columns NAME_outlet_temperature_C and "
     "heat_to_NAME_W"},
    {"fluid", one_of("water|oil"), "as in [coolant]", "fluid of the coolant circuit"},
    {"inlet_temperature_C", between(-50, 150, "C"), "as in [coolant]",
     "coolant temperature at the inlet; without it, the circuit uses the inlet temperature of "
     "[coolant] or of the column coolant_inlet_temperature_C"},
};
constexpr Key channel_keys[]{
    {"flow_l_min", between(0, 1e4, "l/min"), is_required, "volume flow"},
    {"diameter_mm", between(1, 10000, "mm"), is_required, "diameter of the helix of the channel"},
    {"channel_width_mm", between(0.1, 1000, "mm"), is_required,
     "width of the channel along the spindle"},
    {"channel_depth_mm", between(0.1, 1000, "mm"), is_required, "radial depth of the channel"},
    {"pitch_mm", between(0.1, 10000, "mm"), is_required,
     "axial distance from turn to turn, at least channel_width_mm"},
    {"start_mm", anywhere, is_required, "distance of the inlet behind the nose face"},
    {"end_mm", anywhere, is_required, "distance of the outlet behind the nose face"},
    {"stagnant_W_m2K", between(0, 1e5, "W/(m2 K)"), model::Coolant{}.stagnant,
     "heat transfer coefficient without coolant flow"},
    {"throttle_diameter_mm", between(0.1, 1000, "mm"), unset,
     "diameter of an orifice at the outlet, for the pressure drop"},
};

const double usual_share = model::HeatSource{}.rotor_share;
constexpr const char* heat_meaning =
    "heat of the source: a number, or a formula of speed_rpm, axial_load_N, radial_load_N, "
    "moment_Nm, belt_force_N and "
    "motor_power_W";
const Key factor_key{"heat_factor", between(0, 100), model::HeatSource{}.factor,
                     "factor on heat_W if heat_W is a formula; a fit can change this factor"};
const Key motor_keys[]{
    {"heat_W", between(0, 1e6, "W"), 0.0, heat_meaning},
    factor_key,
    {"position_mm", on_the_shaft, is_required,
     "distance of the middle of the motor behind the nose face"},
    {"length_mm", between(0.1, longest_mm, "mm"), is_required, "length of the rotor"},
    {"rotor_diameter_mm", between(0.1, 5000, "mm"), unset, "diameter of the rotor"},
    {"rotor_share", between(0, 1), usual_share, "share of the heat that enters the rotor"},
};
const Key drive_keys[]{
    {"heat_W", between(0, 1e6, "W"), "0 if belt_force_N is given, else required", heat_meaning},
    factor_key,
    {"belt_force_N", between(0, 1e8, "N"), unset,
     "belt force on the shaft; the column belt_force_N of a speed programme replaces this value"},
    {"belt_angle_deg", between(-360, 360, "deg"), 0.0,
     "angle of the belt force, measured from +y (direction of radial loads at the nose) towards "
     "+z"},
    {"position_mm", on_the_shaft, "the shaft behind the last bearing is heated",
     "distance of the belt, and of the middle of the heated part, behind the nose face; required "
     "with belt_force_N"},
    {"length_mm", between(0.1, longest_mm, "mm"), unset, "length of the heated part"},
    {"rotor_diameter_mm", between(0.1, 5000, "mm"), unset, "diameter of the heated part"},
    {"rotor_share", between(0, 1), usual_share, "share of the heat that enters the shaft"},
};
const Key heat_keys[]{
    {"name", a_text, is_required,
     "name of the heat source (letters, digits and _) in the column NAME_heat_W"},
    {"heat_W", between(0, 1e6, "W"), is_required, heat_meaning},
    factor_key,
    {"at", a_text, is_required,
     "place of the heat source: shaft, housing, motor (shaft and housing between the sets), pulley "
     "(shaft behind the last bearing), seal (shaft before the first bearing), or a bearing such as "
     "front_1 or rear_1"},
    {"position_mm", anywhere, "from the key \"at\"",
     "distance of the middle of the heated part behind the nose face; required with at = \"shaft\" "
     "or \"housing\", or if length_mm is given"},
    {"length_mm", between(0.1, longest_mm, "mm"), "from the key \"at\"",
     "length of the heated part; required with at = \"shaft\" or \"housing\", or if position_mm is "
     "given"},
    {"radius_mm", between(0, 5000, "mm"), "all cells from bore to surface",
     "radius of the heated cells of shaft or housing"},
    {"shaft_share", between(0, 1), 0.5,
     "share of the heat that enters the shaft (motor) or the inner ring (bearing)"},
};

constexpr Key sensor_keys[]{
    {"name", a_text, is_required,
     "name of the sensor (letters, digits and _) in the column NAME_temperature_C"},
    {"part", one_of("shaft|ring|housing|coolant"), is_required,
     "part on which the sensor is mounted"},
    {"position_mm", anywhere, unset,
     "distance behind the nose face; required, except in the coolant, where the default is the "
     "outlet"},
    {"radius_mm", between(0, 5000, "mm"), unset,
     "distance from the axis; required, except in the coolant"},
};

using model::ThermometerPlace;

[[noreturn]] void fail_heat(const Section& s, const std::string& formula,
                            const record::FormulaError& error) {
  const Names& known = model::heat_variables;
  std::string hint;
  if (!error.unknown_name.empty()) {
    hint = text::suggestion(error.unknown_name, known);
    hint += "; a formula of heat can use " + text::listed(known);
  }
  s.fail("heat_W", fmt::format("[{}] heat_W: {}{}\n  {}\n  {:>{}}", s.name(), error.what(), hint,
                               formula, "^", error.position + 1));
}

/// Where a machine runs, the formula gives a number that is no cooling.
void require_heat(const Section& s, const record::Expression& heat) {
  for (const double speed_rpm : {0.0, 1000.0, 10000.0}) {
    std::vector<double> values;
    for (const std::size_t name : heat.used())
      values.push_back(model::heat_variables[name] == "speed_rpm" ? speed_rpm : 0.0);
    const double watts = heat(values);
    if (!std::isfinite(watts) || watts < 0.0)
      s.fail("heat_W", fmt::format("[{}] heat_W = \"{}\": the value is {} at {} rpm without load; "
                                   "it must be 0 W or more",
                                   s.name(), heat.text(),
                                   std::isfinite(watts) ? fmt::format("{:.6g} W", watts)
                                                        : std::string("not a number"),
                                   speed_rpm));
  }
}

/// Heat of a source, a number or a formula.
void read_heat(ModelTables& tables, const Section& s, model::HeatSource& source) {
  const toml::node* const node = s.find("heat_W");
  const bool number = !node || node->is_number();
  if (!node) {
    // A record may bring that of the motor; a drive without heat and belt says nothing.
    if (s.name() != "motor" && !s.find("belt_force_N"))
      s.fail_missing("heat_W", ", a number or a formula such as \"0.015*speed_rpm\"");
    tables.note_default(s.name(), "heat_W", "0");
    source.watts = 0.0;
  } else if (number) {
    source.watts = *s.number("heat_W");
  }
  if (number) {
    if (s.find("heat_factor"))
      s.fail("heat_factor",
             fmt::format("heat_factor: only possible if heat_W is a formula, but heat_W is {}",
                         node ? "a number" : "missing"));
    return;
  }
  const std::string formula = *s.text("heat_W");
  try {
    source.formula = std::make_shared<const record::Expression>(formula, model::heat_variables);
    require_heat(s, *source.formula);
  } catch (const record::FormulaError& error) {
    fail_heat(s, formula, error);
  }
  source.factor = s.value("heat_factor");
}

/// Reads the place of a source by its word, or by the bearing of that name.
void read_heated_place(ModelTables& tables, const Section& s, std::size_t index,
                       const Names& bearings, model::HeatSource& source) {
  using Place = model::HeatSource::Place;
  static constexpr std::array<std::pair<const char*, Place>, 5> places{{{"shaft", Place::shaft},
                                                                        {"housing", Place::housing},
                                                                        {"motor", Place::motor},
                                                                        {"pulley", Place::pulley},
                                                                        {"seal", Place::seal}}};
  const auto at = s.text("at");
  Names known;
  for (const auto& [word, place] : places) known.emplace_back(word);
  known.insert(known.end(), bearings.begin(), bearings.end());
  if (!at) s.fail("at", "[heat] at is missing: must be " + text::listed(known, "or"));
  const auto bearing = std::find(bearings.begin(), bearings.end(), *at);
  const auto place =
      std::find_if(places.begin(), places.end(), [&](const auto& one) { return one.first == *at; });
  if (bearing != bearings.end()) {
    source.place = Place::bearing;
    source.bearing = static_cast<std::size_t>(bearing - bearings.begin());
  } else if (place != places.end()) {
    source.place = place->second;
  } else {
    s.fail("at", fmt::format("at = \"{}\": must be {}", *at, text::listed(known, "or")));
  }
  const bool solid = source.place == Place::shaft || source.place == Place::housing;
  const auto refuse = [&](const char* key, const char* why) {
    if (s.find(key)) s.fail(key, fmt::format("{}: at = \"{}\" {}", key, *at, why));
  };
  if (!solid) refuse("radius_mm", "has no radius; only \"shaft\" and \"housing\" have a radius");
  if (source.place == Place::bearing) {
    refuse("position_mm", "already gives the position");
    refuse("length_mm", "already gives the length");
  }
  if (solid || source.place == Place::pulley || source.place == Place::seal)
    refuse("shaft_share", "heats only one part; only a motor or a bearing has a share");
  const bool spanned = s.find("position_mm") || s.find("length_mm");
  for (const char* key : {"position_mm", "length_mm"})
    if ((solid || spanned) && !s.find(key)) s.fail_missing(key);
  s.take("position_mm", source.position, mm);
  s.take("length_mm", source.length, mm);
  s.take("radius_mm", source.radius, mm);
  if (source.place != Place::motor && source.place != Place::bearing) return;
  source.rotor_share = s.value("shaft_share");
  if (!s.find("shaft_share"))
    tables.note_default(fmt::format("heat[{}]", index), "shaft_share",
                        fmt::format("{:.10g}", source.rotor_share));
}

model::Fluid fluid_of(std::string_view word) {
  return word == "water" ? model::Fluid::water : model::Fluid::oil;
}

void require_liquid(const Section& s, model::Fluid fluid, double inlet) {
  if (fluid == model::Fluid::water &&
      !(inlet >= model::water_freezes && inlet <= model::water_boils))
    s.fail("inlet_temperature_C",
           fmt::format("inlet_temperature_C = {:.6g} C: must be from {:g} to {:g} C for fluid = "
                       "\"water\", because water freezes or boils outside this range",
                       celsius(inlet), celsius(model::water_freezes), celsius(model::water_boils)));
}

/// Reads flow and channel of a circuit. `address` names its table in notes.
void read_channel(ModelTables& tables, const Section& s, const std::string& address,
                  model::Coolant& coolant) {
  coolant.flow = s.required("flow_l_min") * model::l_per_min;
  coolant.diameter = s.required("diameter_mm") * mm;
  coolant.channel_width = s.required("channel_width_mm") * mm;
  coolant.channel_depth = s.required("channel_depth_mm") * mm;
  coolant.pitch = s.required("pitch_mm") * mm;
  coolant.start = s.required("start_mm") * mm;
  coolant.end = s.required("end_mm") * mm;
  coolant.stagnant = s.value("stagnant_W_m2K");
  if (!s.find("stagnant_W_m2K"))
    tables.note_default(address, "stagnant_W_m2K", fmt::format("{:.10g}", coolant.stagnant));
  s.take("throttle_diameter_mm", coolant.throttle_diameter, mm);
  if (coolant.pitch < coolant.channel_width)
    s.fail("pitch_mm", fmt::format("pitch_mm = {:.10g} mm: must be at least channel_width_mm = "
                                   "{:.10g} mm, because the turns of the channel must not overlap",
                                   coolant.pitch / mm, coolant.channel_width / mm));
  if (coolant.end <= coolant.start)
    s.fail("end_mm", fmt::format("end_mm = {:.10g} mm: must be above start_mm = {:.10g} mm",
                                 coolant.end / mm, coolant.start / mm));
}

ThermometerPlace::Part part_of(const Section& s) {
  const auto part = s.choice("part");
  if (!part) s.fail("part", "[sensor] part is missing: must be shaft, ring, housing or coolant");
  return *part == "shaft"     ? ThermometerPlace::Part::shaft
         : *part == "ring"    ? ThermometerPlace::Part::ring
         : *part == "housing" ? ThermometerPlace::Part::housing
                              : ThermometerPlace::Part::coolant;
}

std::string sensor_name(const Section& s, const std::vector<ThermometerPlace>& before) {
  const auto name = s.text("name");
  if (!name)
    s.fail("name", "[sensor] name is missing: it becomes part of the column NAME_temperature_C");
  const auto fail = [&](const std::string& why) {
    s.fail("name", fmt::format("name = \"{}\": {}", *name, why));
  };
  if (!names_a_column(*name))
    fail("must be letters, digits and _, because it becomes part of the column NAME_temperature_C");
  for (const char* taken : {"ambient", "machine", "coolant_inlet", "inner_ring", "outer_ring"})
    if (*name == taken)
      fail(
          fmt::format("raceway already has a column {}_temperature_C; choose another name", taken));
  for (const ThermometerPlace& other : before)
    if (other.name == *name) fail("another sensor has this name; choose another name");
  return *name;
}

}  // namespace

bool names_a_column(std::string_view name) {
  const auto ordinary = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), ordinary);
}

std::vector<KeyTable> surroundings_tables() {
  return {{"ambient", ambient_keys},
          {"coolant", coolant_keys},
          {"coolant", channel_keys},
          {"coolant.circuit", circuit_keys},
          {"coolant.circuit", channel_keys},
          {"motor", motor_keys},
          {"drive", drive_keys},
          {"heat", heat_keys},
          {"sensor", sensor_keys}};
}

model::Ambient read_ambient(ModelTables& tables) {
  const Section s = tables.section("ambient", {ambient_keys});
  model::Ambient ambient;
  ambient.temperature = kelvin(tables.number(s, "temperature_C"));
  if (const auto value = s.number("machine_temperature_C"))
    ambient.machine_temperature = kelvin(*value);
  else
    tables.note_default(s, "machine_temperature_C",
                        fmt::format("{:.10g}", celsius(ambient.temperature)));
  ambient.emissivity = tables.number(s, "emissivity");
  ambient.convection_factor = tables.number(s, "convection_factor");
  const std::string law = tables.choice(s, "rotating_convection");
  ambient.rotating_convection = law == "becker"     ? model::RotatingConvection::becker
                                : law == "kendoush" ? model::RotatingConvection::kendoush
                                                    : model::RotatingConvection::anderson_saunders;
  return ambient;
}

std::optional<model::Coolant> read_coolant(ModelTables& tables, const model::Ambient& ambient) {
  const Section s = tables.section("coolant", {coolant_keys, channel_keys});
  if (!s.given()) return std::nullopt;
  model::Coolant coolant;
  coolant.fluid = fluid_of(tables.choice(s, "fluid"));
  coolant.inlet_temperature =
      kelvin(tables.number(s, "inlet_temperature_C", celsius(ambient.temperature)));
  require_liquid(s, coolant.fluid, coolant.inlet_temperature);
  read_channel(tables, s, "coolant", coolant);
  return coolant;
}

std::vector<Section> circuit_sections(const ModelTables& tables) {
  return tables_in(tables.section("coolant"), "circuit", {circuit_keys, channel_keys});
}

std::vector<model::Circuit> read_circuits(ModelTables& tables, const model::Coolant& first) {
  std::vector<model::Circuit> list;
  for (const Section& s : circuit_sections(tables)) {
    const auto name = s.text("name");
    if (!name)
      s.fail("name",
             "[coolant.circuit] name is missing: it becomes part of column names of the result");
    const auto fail = [&](std::string_view why) {
      s.fail("name", fmt::format("name = \"{}\": {}", *name, why));
    };
    if (!names_a_column(*name)) fail("must be letters, digits and _");
    for (const char* taken : {"coolant", "air", "machine"})
      if (*name == taken)
        fail(fmt::format("the result already has a column heat_to_{}_W; choose another name",
                         taken));
    for (const model::Circuit& other : list)
      if (other.name == *name) fail("another circuit has this name; choose another name");
    const std::string address = fmt::format("coolant.circuit[{}]", list.size());
    model::Circuit circuit{.name = *name, .channel = {.fluid = first.fluid}};
    if (const auto fluid = s.choice("fluid"))
      circuit.channel.fluid = fluid_of(*fluid);
    else
      tables.note_default(address, "fluid",
                          first.fluid == model::Fluid::water ? "\"water\"" : "\"oil\"",
                          "as in [coolant]");
    double inlet = first.inlet_temperature;
    if (const auto given = s.number("inlet_temperature_C"))
      circuit.channel.inlet_temperature = inlet = kelvin(*given);
    else
      tables.note_default(address, "inlet_temperature_C", fmt::format("{:.10g}", celsius(inlet)),
                          "as in [coolant]");
    require_liquid(s, circuit.channel.fluid, inlet);
    read_channel(tables, s, address, circuit.channel);
    list.push_back(std::move(circuit));
  }
  return list;
}

std::optional<model::HeatSource> read_heat_source(ModelTables& tables, std::string_view table) {
  const bool motor = table == "motor";
  const Section s = tables.section(
      table, {motor ? std::span<const Key>(motor_keys) : std::span<const Key>(drive_keys)});
  if (!s.given()) return std::nullopt;
  model::HeatSource source{
      .name = std::string(table),
      .place = motor ? model::HeatSource::Place::motor : model::HeatSource::Place::pulley};
  read_heat(tables, s, source);
  s.take("position_mm", source.position, mm);
  s.take("length_mm", source.length, mm);
  s.take("rotor_diameter_mm", source.rotor_diameter, mm);
  source.rotor_share = motor ? tables.number(s, "rotor_share") : s.value("rotor_share");
  return source;
}

std::vector<model::HeatSource> read_heat_sources(ModelTables& tables, const Names& bearings) {
  std::vector<model::HeatSource> list;
  for (const Section& s : heat_sections(tables, {heat_keys})) {
    model::HeatSource source;
    const auto name = s.text("name");
    if (!name) s.fail("name", "[heat] name is missing: it becomes part of the column NAME_heat_W");
    const auto fail = [&](const char* why) {
      s.fail("name", fmt::format("name = \"{}\": {}", *name, why));
    };
    if (!names_a_column(*name)) fail("must be letters, digits and _");
    for (const char* taken : {"motor", "drive"})
      if (*name == taken) fail("is the name of another table; choose another name");
    for (const model::HeatSource& other : list)
      if (other.name == *name) fail("another source of heat has this name; choose another name");
    source.name = *name;
    read_heat(tables, s, source);
    read_heated_place(tables, s, list.size(), bearings, source);
    list.push_back(std::move(source));
  }
  return list;
}

std::optional<model::Belt> read_belt(const ModelTables& tables) {
  const Section s = tables.section("drive", {drive_keys});
  const auto force = s.number("belt_force_N");
  if (!force) {
    if (s.find("belt_angle_deg"))
      s.fail("belt_angle_deg",
             "belt_angle_deg: belt_force_N is missing; set belt_force_N = 0 if speed programmes "
             "give the force");
    return std::nullopt;
  }
  return model::Belt{.force = *force,
                     .angle = s.value("belt_angle_deg") * degree,
                     .position = s.required("position_mm") * mm};
}

std::vector<ThermometerPlace> read_sensors(const ModelTables& tables) {
  std::vector<ThermometerPlace> list;
  for (const Section& s : sensor_sections(tables, {sensor_keys})) {
    ThermometerPlace place{.name = sensor_name(s, list)};
    place.part = part_of(s);
    const bool optional = place.part == ThermometerPlace::Part::coolant;
    const auto take = [&](double& value, std::string_view key) {
      if (!s.take(key, value, mm) && !optional) s.fail_missing(key);
    };
    take(place.position, "position_mm");
    take(place.radius, "radius_mm");
    list.push_back(std::move(place));
  }
  return list;
}

}  // namespace raceway::files
