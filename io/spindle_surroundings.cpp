#include <algorithm>
#include <cmath>
#include <memory>

#include "record/series_channel.h"
#include "record/units.h"

// Last: see io/toml_text.h.
#include "io/spindle_parts.h"

namespace raceway::io {
namespace {

constexpr double litre_per_minute = 1e-3 / 60.0;  ///< [m³/s]

using model::ThermometerPlace;

[[noreturn]] void fail_heat(const Section& s, const std::string& formula,
                            const record::FormulaError& error) {
  const Names& known = model::heat_variables;
  std::string hint;
  if (!error.unknown_name.empty()) {
    hint = suggestion(error.unknown_name, known);
    hint += "; a formula of heat knows " + listed(known);
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
      s.fail("heat_W", fmt::format("[{}] heat_W = \"{}\": gives {} at {} rpm without load: must be "
                                   "a number of watts from 0",
                                   s.name(), heat.text(),
                                   std::isfinite(watts) ? fmt::format("{:.6g} W", watts)
                                                        : std::string("no number"),
                                   speed_rpm));
  }
}

std::shared_ptr<const record::Expression> read_heat(ModelTables& tables, const Section& s) {
  const toml::node* const node = s.find("heat_W");
  std::string formula;
  if (!node) {
    // A record may bring that of the motor; a drive without heat says nothing.
    if (s.name() != "motor")
      s.fail_missing({"heat_W", "W", 0, 1e6}, ", a number or a formula as \"0.015*speed_rpm\"");
    tables.note_default(s.name(), "heat_W", "0");
    formula = "0";
  } else if (node->is_number()) {
    formula = fmt::format("{:.17g}", *s.number({"heat_W", "W", 0, 1e6}));
  } else {
    formula = *s.text("heat_W");
  }
  try {
    auto heat = std::make_shared<const record::Expression>(formula, model::heat_variables);
    require_heat(s, *heat);
    return heat;
  } catch (const record::FormulaError& error) {
    fail_heat(s, formula, error);
  }
}

ThermometerPlace::Part part_of(const Section& s) {
  const auto part = s.choice("part", {"shaft", "ring", "housing", "coolant"});
  if (!part) s.fail("part", "[sensor] part is missing: must be shaft, ring, housing or coolant");
  return *part == "shaft"     ? ThermometerPlace::Part::shaft
         : *part == "ring"    ? ThermometerPlace::Part::ring
         : *part == "housing" ? ThermometerPlace::Part::housing
                              : ThermometerPlace::Part::coolant;
}

std::string sensor_name(const Section& s, const std::vector<ThermometerPlace>& before) {
  const auto name = s.text("name");
  if (!name) s.fail("name", "[sensor] name is missing: it gives the column NAME_temperature_C");
  const auto fail = [&](const std::string& why) {
    s.fail("name", fmt::format("name = \"{}\": {}", *name, why));
  };
  if (!names_a_column(*name))
    fail("must be letters, digits and _, since it gives the column NAME_temperature_C");
  for (const char* taken : {"ambient", "machine", "coolant_inlet", "inner_ring", "outer_ring"})
    if (*name == taken)
      fail(fmt::format("{}_temperature_C is a column of its own; take another name", taken));
  for (const ThermometerPlace& other : before)
    if (other.name == *name) fail("another sensor has this name");
  return *name;
}

}  // namespace

bool names_a_column(std::string_view name) {
  const auto ordinary = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), ordinary);
}

model::Ambient read_ambient(ModelTables& tables) {
  const Section s = tables.section("ambient");
  s.allow_only({"temperature_C", "machine_temperature_C", "emissivity", "convection_factor",
                "rotating_convection"});
  model::Ambient ambient;
  ambient.temperature =
      kelvin(tables.number_or(s, {"temperature_C", "C", -100, 200}, celsius(ambient.temperature)));
  if (const auto value = s.number({"machine_temperature_C", "C", -100, 200}))
    ambient.machine_temperature = kelvin(*value);
  else
    tables.note_default("ambient", "machine_temperature_C",
                        fmt::format("{:.10g}", celsius(ambient.temperature)),
                        "default: that of the ambient");
  ambient.emissivity = tables.number_or(s, {"emissivity", "", 0, 1}, ambient.emissivity);
  ambient.convection_factor =
      tables.number_or(s, {"convection_factor", "", 0, 20}, ambient.convection_factor);
  const std::string law = tables.choice_or(s, "rotating_convection",
                                           {"becker", "kendoush", "anderson-saunders"}, "becker");
  ambient.rotating_convection = law == "becker"     ? model::RotatingConvection::becker
                                : law == "kendoush" ? model::RotatingConvection::kendoush
                                                    : model::RotatingConvection::anderson_saunders;
  return ambient;
}

std::optional<model::Coolant> read_coolant(ModelTables& tables, const model::Ambient& ambient) {
  const Section s = tables.section("coolant");
  if (!s.given()) return std::nullopt;
  s.allow_only({"fluid", "flow_l_min", "inlet_temperature_C", "diameter_mm", "channel_width_mm",
                "channel_depth_mm", "pitch_mm", "start_mm", "end_mm", "stagnant_W_m2K"});
  model::Coolant coolant;
  coolant.fluid = tables.choice_or(s, "fluid", {"water", "oil"}, "water") == "water"
                      ? model::Fluid::water
                      : model::Fluid::oil;
  coolant.flow = s.required({"flow_l_min", "l/min", 0, 1e4}) * litre_per_minute;
  coolant.inlet_temperature = kelvin(
      tables.number_or(s, {"inlet_temperature_C", "C", -50, 150}, celsius(ambient.temperature)));
  coolant.diameter = s.required({"diameter_mm", "mm", 1, 10000}) * mm;
  coolant.channel_width = s.required({"channel_width_mm", "mm", 0.1, 1000}) * mm;
  coolant.channel_depth = s.required({"channel_depth_mm", "mm", 0.1, 1000}) * mm;
  coolant.pitch = s.required({"pitch_mm", "mm", 0.1, 10000}) * mm;
  coolant.start = s.required({"start_mm", "mm", -longest_mm, longest_mm}) * mm;
  coolant.end = s.required({"end_mm", "mm", -longest_mm, longest_mm}) * mm;
  coolant.stagnant = tables.number_or(s, {"stagnant_W_m2K", "W/(m2 K)", 0, 1e5}, coolant.stagnant);
  if (coolant.pitch < coolant.channel_width)
    s.fail("pitch_mm", fmt::format("pitch_mm = {:.10g} mm: must be at least channel_width_mm = "
                                   "{:.10g} mm, or the turns of the channel run into each other",
                                   coolant.pitch / mm, coolant.channel_width / mm));
  if (coolant.end <= coolant.start)
    s.fail("end_mm", fmt::format("end_mm = {:.10g} mm: must be above start_mm = {:.10g} mm",
                                 coolant.end / mm, coolant.start / mm));
  return coolant;
}

std::optional<model::HeatSource> read_heat_source(ModelTables& tables, std::string_view table) {
  const Section s = tables.section(table);
  if (!s.given()) return std::nullopt;
  const bool motor = table == "motor";
  s.allow_only({"heat_W", "position_mm", "length_mm", "rotor_diameter_mm", "rotor_share"});
  model::HeatSource source{.heat = read_heat(tables, s)};
  const Key position{"position_mm", "mm", 0, longest_mm},
      length{"length_mm", "mm", 0.1, longest_mm};
  if (motor) {
    source.position = s.required(position) * mm;
    source.length = s.required(length) * mm;
  } else {
    if (const auto value = s.number(position)) source.position = *value * mm;
    if (const auto value = s.number(length)) source.length = *value * mm;
  }
  if (const auto value = s.number({"rotor_diameter_mm", "mm", 0.1, 5000}))
    source.rotor_diameter = *value * mm;
  const Key share{"rotor_share", "", 0, 1};
  source.rotor_share = motor ? tables.number_or(s, share, source.rotor_share)
                             : s.number(share).value_or(source.rotor_share);
  return source;
}

std::vector<ThermometerPlace> read_sensors(const ModelTables& tables) {
  const Section root(tables.source(), "", &tables.root());
  std::vector<ThermometerPlace> list;
  for (const Section& s : tables_in(root, "sensor")) {
    s.allow_only({"name", "part", "position_mm", "radius_mm"});
    ThermometerPlace place{.name = sensor_name(s, list)};
    place.part = part_of(s);
    const Key position{"position_mm", "mm", -longest_mm, longest_mm},
        radius{"radius_mm", "mm", 0, 5000};
    const bool optional = place.part == ThermometerPlace::Part::coolant;
    const auto take = [&](double& value, const Key& key) {
      if (const auto given = s.number(key))
        value = *given * mm;
      else if (!optional)
        s.fail_missing(key);
    };
    take(place.position, position);
    take(place.radius, radius);
    list.push_back(std::move(place));
  }
  return list;
}

}  // namespace raceway::io
