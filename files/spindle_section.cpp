#include <algorithm>
#include <cmath>

#include "files/detail/number_lists.h"
#include "model/rings.h"
#include "record/units.h"
#include "spindle/bearing_conduction.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/roller_section.h"
#include "files/detail/spindle_parts.h"
#include "files/detail/spindle_section.h"

namespace raceway::files {
namespace {

const model::Spindle usual_spindle;
constexpr Key own_spindle_keys[]{
    {"name", a_text, "name of the bearing", "name in the results"},
    {"preload_feedback", a_flag, "true",
     "preload for the calculation of the friction; true: forces of the bearing sets in the warm "
     "spindle, false: forces in the cold spindle at the same speed"},
};
// In tables that other models have too.
const Key spindle_bearing_keys[]{
    {"width_mm", between(0.5, 1000, "mm"), "from the catalogue, else (outer diameter - bore) / 2",
     "width of the rings"},
    {"inner_ring_shoulder_mm", between(1, 5000, "mm"), "pitch diameter - 0.7 ball diameters",
     "shoulder diameter of the inner ring"},
    {"outer_ring_shoulder_mm", between(1, 10000, "mm"), "pitch diameter + 0.7 ball diameters",
     "shoulder diameter of the outer ring"},
    {"lubricant_conductance_W_K", between(0, 1000, "W/K"),
     "1650 W/(m2 K) x number of balls x squared ball diameter",
     "thermal conductance from ring to ring through oil and rolling balls, in addition to the "
     "contacts"},
};
constexpr Key spindle_friction_keys[]{{"inner_heat_share", between(0, 1),
                                       "calculated from the sliding friction at each ring",
                                       "share of the friction heat that enters the inner ring"}};
constexpr Key spindle_solver_keys[]{
    {"cells", one_of("coarse|medium|fine"), "medium", "size of the mesh cells"},
    {"step_s", between(0.01, 1e5, "s"), "from the error control", "longest time step"},
};
const Key spindle_rig_keys[]{
    {"model_floor_K", between(0, 100, "K"), usual_spindle.model_floor_temperature,
     "expected error of the calculated temperatures; diagnose accepts residuals of this size"},
    {"model_floor_um", between(0, 1000, "um"), usual_spindle.model_floor_displacement / um,
     "expected error of the calculated displacements; diagnose accepts residuals of this size"},
};

const KeyTable tables_of_keys[]{{"bearing", spindle_bearing_keys, "spindle"},
                                {"friction", spindle_friction_keys, "spindle"},
                                {"solver", spindle_solver_keys, "spindle"},
                                {"rig", spindle_rig_keys, "spindle"},
                                {"spindle", own_spindle_keys}};

using model::Cells;
using model::Spindle;

void read_name(ModelTables& tables, const std::string& bearing, Spindle& spindle) {
  const Section s = tables.section("spindle", {own_spindle_keys});
  if (const auto name = s.text("name"))
    spindle.name = *name;
  else
    tables.note_default(s, "name", fmt::format("\"{}\"", spindle.name = bearing));
  const toml::node* const feedback = s.find("preload_feedback");
  if (!feedback)
    tables.note_default("spindle", "preload_feedback", "true");
  else if (!feedback->is_boolean())
    s.fail("preload_feedback", fmt::format("preload_feedback = {}: must be true or false, not {}",
                                           text::shown(*feedback), kind(*feedback)));
  else
    spindle.preload_feedback = *feedback->value<bool>();
}

/// Envelope of the rings, and what they conduct beside their contacts.
void read_rings(ModelTables& tables, const NamedBearing& bearing, Spindle& spindle) {
  const Section s = tables.part("bearing", {spindle_bearing_keys});
  const bearing::BearingGeometry& g = bearing.bearing.geometry();
  const auto take = [&](double& value, std::string_view key, double fallback,
                        const std::string& why = "", auto... origin) {
    if (s.take(key, value, mm)) return;
    value = fallback;
    const std::string text = fmt::format("{:.6g}", value / mm);
    why.empty() ? tables.note_default(s, key, text)
                : tables.note_default(s.name(), key, text, why, origin...);
  };
  if (bearing.row && !std::isnan(bearing.row->width))
    take(spindle.bearing_width, "width_mm", bearing.row->width, "from the catalogue",
         UsedDefault::Origin::catalogue);
  else
    take(spindle.bearing_width, "width_mm", 0.5 * (g.outer_diameter - g.bore),
         "default: (outer diameter - bore) / 2");
  take(spindle.inner_ring_shoulder, "inner_ring_shoulder_mm",
       g.pitch_diameter - 0.7 * g.ball_diameter);
  take(spindle.outer_ring_shoulder, "outer_ring_shoulder_mm",
       g.pitch_diameter + 0.7 * g.ball_diameter);
  const auto require = [&](const char* key, double value, double lower, double upper,
                           const char* limits) {
    if (!(value > lower && value < upper))
      s.fail(key, fmt::format("{} = {:.6g} mm: must be between {:.6g} and {:.6g} mm, {}", key,
                              value / mm, std::min(lower, upper) / mm, std::max(lower, upper) / mm,
                              limits));
  };
  require("inner_ring_shoulder_mm", spindle.inner_ring_shoulder, g.bore, g.pitch_diameter,
          "the bore and the pitch diameter of the bearing");
  require("outer_ring_shoulder_mm", spindle.outer_ring_shoulder, g.pitch_diameter, g.outer_diameter,
          "the pitch diameter and the outer diameter of the bearing");
  spindle.lubricant_conductance =
      tables.number(s, "lubricant_conductance_W_K", spindle::usual_lubricant_conductance(g));
}

void read_solution(ModelTables& tables, Spindle& spindle) {
  const Section solver = tables.part("solver", {spindle_solver_keys});
  const std::string cells = tables.choice(solver, "cells");
  spindle.cells = cells == "coarse" ? Cells::coarse : cells == "fine" ? Cells::fine : Cells::medium;
  if (!solver.take("step_s", spindle.step))
    tables.note_default("solver", "step_s", "from the error control");
  const Section rig = tables.part("rig", {spindle_rig_keys});
  spindle.model_floor_temperature = tables.number(rig, "model_floor_K");
  spindle.model_floor_displacement = tables.number(rig, "model_floor_um") * um;
}

void read_positions(const ModelTables& tables, const model::Shaft& shaft, Spindle& spindle) {
  const Section s = tables.section("arrangement");
  const std::size_t front = shaft.arrangement.front_count();
  const std::size_t rear = shaft.arrangement.bearings().size() - front;
  const auto read = [&](const char* key, std::size_t count) {
    if (!s.find(key)) {
      if (spindle.network) return std::vector<double>();
      throw MissingKey(
          fmt::format("{}: [arrangement] {} is missing: give a list of numbers (bearings: {}), the "
                      "distances of the bearing centres behind the nose face",
                      s.place(), key, count),
          s.at(key));
    }
    std::vector<double> list = numbers(s, key, *s.find(key), count);
    for (double& value : list) value *= mm;
    return list;
  };
  spindle.front_positions = read("front_position_mm", front);
  spindle.rear_positions = read("rear_position_mm", rear);
}

}  // namespace

const Names& tables_of_spindle() {
  static const Names names{"spindle", "shaft", "housing", "seat", "coolant", "ambient",
                           "motor",   "drive", "heat",    "gap",  "network", "sensor"};
  return names;
}

bool is_spindle(const ModelTables& tables) {
  const auto has = [&](std::string_view name) { return tables.root().contains(name); };
  const auto fail = [&](std::string_view table, const std::string& why) {
    const toml::node* const node = tables.root().get(table);
    throw text::InputError(
        fmt::format("{}:{}: [{}]: {}", tables.source(), node->source().begin.line, table, why),
        {.file = tables.source(),
         .line = static_cast<int>(node->source().begin.line),
         .key = std::string(table)});
  };
  if (has("network"))
    for (const char* other :
         {"shaft", "housing", "gap", "motor", "drive", "heat", "coolant", "seat"})
      if (has(other))
        fail(other,
             "not possible together with [network], which replaces the geometry; remove one of the "
             "two");
  if (!has("network") && has("shaft") != has("housing"))
    fail(has("shaft") ? "shaft" : "housing",
         has("shaft") ? "a spindle needs both [shaft] and [housing]; add [housing]"
                      : "a spindle needs both [shaft] and [housing]; add [shaft]");
  const bool spindle = has("network") || has("shaft");
  if (!spindle)
    for (const std::string& name : tables_of_spindle())
      if (has(name)) fail(name, "only possible for a spindle, which needs [shaft] and [housing]");
  return spindle;
}

std::vector<KeyTable> spindle_tables() {
  return {std::begin(tables_of_keys), std::end(tables_of_keys)};
}

Keys spindle_keys(std::string_view table, bool spindle) {
  for (const KeyTable& one : tables_of_keys)
    if (spindle && one.name == table) return {one.keys};
  return {};
}

model::Spindle read_spindle(ModelTables& tables, const NamedBearing& bearing,
                            const model::Shaft* shaft, Names& notes) {
  if (!shaft)
    throw MissingKey(
        fmt::format("{}: table [arrangement] is missing; it gives the bearing sets of the spindle",
                    tables.source()),
        {.file = tables.source(), .key = "arrangement"});
  if (shaft->arrangement.design().rear.empty()) {
    const Section arrangement = tables.section("arrangement");
    arrangement.fail("layout",
                     fmt::format("layout = {}: not possible, because this is a tandem arrangement, "
                                 "but a spindle needs a front and a rear set; use O or X",
                                 text::shown(*arrangement.find("layout"))));
  }
  Spindle spindle;
  read_name(tables, bearing.name, spindle);
  read_rings(tables, bearing, spindle);
  if (const auto share =
          tables.part("friction", {spindle_friction_keys}).number("inner_heat_share"))
    spindle.inner_heat_share = *share;
  else
    tables.note_default("friction", "inner_heat_share",
                        "calculated from the sliding friction at each ring");
  read_solution(tables, spindle);
  spindle.ambient = read_ambient(tables);
  if (tables.root().contains("network")) spindle.network = read_network(tables, spindle.ambient);
  read_positions(tables, *shaft, spindle);
  if (spindle.network) {
    spindle.sensors = sensors_of_network(tables, *spindle.network);
    return spindle;
  }
  spindle.sensors = read_sensors(tables);
  spindle.shaft = read_shaft_body(tables);
  spindle.rollers = read_rollers_on_shaft(tables);
  spindle.housing = read_housing(tables);
  spindle.seat = read_seat(tables);
  spindle.coolant = read_coolant(tables, spindle.ambient);
  if (spindle.coolant) spindle.circuits = read_circuits(tables, *spindle.coolant);
  spindle.motor = read_heat_source(tables, "motor");
  spindle.drive = read_heat_source(tables, "drive");
  spindle.heat = read_heat_sources(
      tables, model::bearing_names(spindle.front_positions.size(), spindle.rear_positions.size(),
                                   spindle.rollers));
  spindle.belt = read_belt(tables);
  spindle.gap = read_gap(tables);
  check_spindle(tables, spindle, *shaft, notes);
  return spindle;
}

}  // namespace raceway::files
