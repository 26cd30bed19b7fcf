#include "files/model_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "files/plausible.h"
#include "files/subject.h"
#include "model/needs.h"
#include "text/input_file.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/bearing_section.h"
#include "files/detail/column_section.h"
#include "files/detail/contact_section.h"
#include "files/detail/effect_section.h"
#include "files/detail/friction_section.h"
#include "files/detail/loop_section.h"
#include "files/detail/marked_values.h"
#include "files/detail/model_reader.h"
#include "files/detail/rig_section.h"
#include "files/detail/roller_section.h"
#include "files/detail/sensor_section.h"
#include "files/detail/shaft_section.h"
#include "files/detail/spindle_parts.h"
#include "files/detail/spindle_section.h"

namespace raceway::files {
namespace {

void check_tables(const ModelTables& tables) {
  Names known{"bearing", "lubricant",     "friction",    "arrangement", "rig",
              "solver",  "material",      "calibration", "loop",        "effect",
              "columns", "torque_sensor", "correction",  "life"};
  if (tables.root().contains("correction")) known.emplace_back("export");
  const Names& of_spindle = tables_of_spindle();
  known.insert(known.end(), of_spindle.begin(), of_spindle.end());
  for (const auto& [key, node] : tables.root()) {
    const std::string name(key.str());
    const std::string place = tables.place(key);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      if (!node.is_table() && !node.is_array_of_tables())
        throw text::InputError(
            fmt::format(
                "{}: {} = {}: the key is not in a table; move it below [bearing] or another table",
                place, name, text::shown(node)),
            tables.at(key));
      const std::string near = text::suggestion(name, known);
      throw text::InputError(
          fmt::format("{}: [{}]: unknown table{}", place, name,
                      near.empty() ? "; a model has " + text::listed(known) : near),
          tables.at(key));
    }
    if (name == "correction") continue;  // of the same machine, over time: files/correction_file.h
    if (name == "effect" || name == "sensor" || name == "heat") {
      if (!node.is_array() || !(node.as_array()->empty() || node.is_array_of_tables()))
        throw text::InputError(
            fmt::format("{0}: write {1} as [[{1}]] with two brackets", place, name),
            tables.at(key));
    } else if (!node.is_table()) {
      throw text::InputError(fmt::format("{}: {} = {}: must be a table, written as [{}]", place,
                                         name, text::shown(node), name),
                             tables.at(key));
    }
  }
}

/// Of shaft and housing, with which the sets are reckoned where [arrangement] says nothing else.
std::pair<double, double> expansions_of(const ModelTables& tables, bool spindle) {
  if (!spindle) return {unset, unset};
  return {expansion_of(tables, "shaft", model::steel_of_shafts.thermal_expansion),
          expansion_of(tables, "housing", model::iron_of_housings.thermal_expansion)};
}

template <typename List>
List joined(List list, const List& further) {
  list.insert(list.end(), further.begin(), further.end());
  return list;
}

/// Effects that the base law has itself stand in no model of it.
void refuse_effects_of_law(const ModelTables& tables, const model::Model& model) {
  for (std::size_t k = 0; k < model.effects.size(); ++k)
    if (const std::string why = refused_by_law(*model.effects[k].description, model);
        !why.empty()) {
      const Section s(tables.source(), "effect",
                      tables.root()["effect"].as_array()->get(k)->as_table());
      s.fail("id", fmt::format("id = \"{}\": the effect needs {}", model.effects[k].description->id,
                               why));
    }
}

/// Reads [arrangement], where there is one. Its bearings change keys of `base`.
std::optional<model::Shaft> read_arrangement(ModelTables& tables, BearingReader& bearings,
                                             const NamedBearing& base, friction::FrictionLaw law,
                                             bool spindle) {
  const Section s = tables.section("arrangement");
  if (!s.given()) return std::nullopt;
  const ShaftContext context{.base = base,
                             .read_bearing =
                                 [&](const Section& table, Keys further) {
                                   NamedBearing one =
                                       bearings.read(table, &base, std::move(further));
                                   require_data(law, one.bearing, table);
                                   return one;
                                 },
                             .note_default =
                                 [&](std::string_view key, const std::string& value) {
                                   tables.note_default("arrangement", key, value);
                                 },
                             .expansions = expansions_of(tables, spindle)};
  return read_shaft(s, context);
}

/// Effects that are switched on although the supply of lubricant rules them out.
std::vector<std::string> notes_on_effects(const model::Model& model) {
  std::vector<std::string> notes;
  for (const effects::Effect& e : model.effects)
    if (const std::string why = model::ruled_out(*e.description, model); !why.empty())
      notes.push_back(fmt::format("effect {}: {}; the model uses the effect nevertheless",
                                  e.description->id, why));
  return notes;
}

/// What lies within its range, but not where such numbers lie.
void note_the_implausible(const model::Model& model, std::vector<std::string>& notes) {
  const auto note = [&](std::string text) {
    if (!text.empty() && std::find(notes.begin(), notes.end(), text) == notes.end())
      notes.push_back(std::move(text));
  };
  if (const bearing::Bearing* const balls = model.bearing.ball_bearing())
    note(looks_like_inches(balls->geometry()));
  if (model.shaft)
    for (const bearing::MountedBearing& m : model.shaft->arrangement.bearings())
      note(looks_like_inches(m.bearing->geometry()));
  note(looks_like_kelvin("temperature_C", celsius(model.rig.temperature)));
  note(looks_like_kelvin("room_temperature_C", celsius(model.rig.room_temperature)));
}

/// A model of its own tables, with what stands beside in the file.
struct ReadModel {
  model::Model model;
  std::string catalogue = {};
  Names written = {}, notes = {};
};

ReadModel read_ball_model(ModelTables& tables) {
  const bool of_spindle = is_spindle(tables);
  BearingReader bearings(tables);
  NamedBearing bearing = bearings.read(
      tables.required_section("bearing", "the geometry of the bearing, or catalogue = \"NAME\""),
      nullptr, joined(spindle_keys("bearing", of_spindle), Keys{contact_keys("bearing")}));
  const LubricantOfFile lubricant = read_lubricant(tables);
  LawOfFile law =
      read_friction(tables, !bearing.catalogue.empty(), spindle_keys("friction", of_spindle));
  require_data(law.law, bearing.bearing, tables.section("bearing"));
  std::optional<model::Shaft> shaft =
      read_arrangement(tables, bearings, bearing, law.law, of_spindle);
  Names notes_on_spindle;
  std::optional<model::Spindle> spindle;
  if (of_spindle)
    spindle = read_spindle(tables, bearing, shaft ? &*shaft : nullptr, notes_on_spindle);
  std::vector<effects::Effect> effects =
      read_effects(tables, shaft ? &*shaft : nullptr, of_spindle);
  const SolverOfFile solver = read_solver(tables, law.law, spindle_keys("solver", of_spindle));
  Names written = joined(bearings.written(), written_contact_keys(tables));
  const friction::contact::ContactData contact =
      read_contact(tables, law.law == friction::FrictionLaw::contact, lubricant.supply);
  if (solver.options.race_control != bearing::RaceControl::outer)
    written.emplace_back("race_control");
  if (solver.options.tilt != bearing::Tilt::locked) written.emplace_back("tilt");
  const model::Rig rig = read_rig(tables, spindle_keys("rig", of_spindle));
  std::string catalogue = bearing.catalogue;
  model::PrintedSpeed printed_speed;
  if (bearing.row && !(shaft && shaft->own_bearings))
    printed_speed = {.oil = bearing.row->speed_limit_oil,
                     .grease = bearing.row->speed_limit_grease};
  model::Model model{
      .name = bearing.name,
      .bearing = shaft ? *shaft->arrangement.bearings()[0].bearing : std::move(bearing.bearing),
      .lubricant = lubricant.lubricant,
      .supply = lubricant.supply,
      .law = law.law,
      .f1_load = law.f1_load,
      .law_values = std::move(law.values),
      .contact = contact,
      .table = std::move(law.table),
      .effects = std::move(effects),
      .solver = solver.options,
      .balanced_balls = solver.balanced_balls,
      .life = read_life(tables),
      .printed_speed = printed_speed,
      .rig = rig,
      .free = {},
      .shaft = std::move(shaft),
      .spindle = std::move(spindle)};
  return {std::move(model), std::move(catalogue), std::move(written), std::move(notes_on_spindle)};
}

}  // namespace

ModelFile model_of_tables(ModelTables& tables, std::string text) {
  const std::string& source = tables.source();
  check_tables(tables);
  ReadModel read = has_rollers(tables) ? ReadModel{.model = read_roller_model(tables),
                                                   .written = written_contact_keys(tables)}
                                       : read_ball_model(tables);
  model::Model& model = read.model;
  const model::Rig& rig = model.rig;
  refuse_effects_of_law(tables, model);
  if (std::isnan(rig.room_temperature))
    for (const effects::Effect& e : model.effects)
      if (e.description->uses_room)
        throw text::InputError(
            fmt::format(
                "{}: the effect {} needs room_temperature_C under [rig], because the temperature "
                "sensor measures only a share of the rise above this temperature",
                source, e.description->id),
            {.file = source, .key = "room_temperature_C"});
  model.free = read_free(tables, model);
  model.tolerances = read_tolerances(tables, model);
  ColumnMap columns = read_columns(tables);
  std::optional<rig::TorqueSensor> sensor = read_torque_sensor(tables);
  std::vector<std::string> notes = notes_on_effects(model);
  notes.insert(notes.end(), read.notes.begin(), read.notes.end());
  note_the_implausible(model, notes);
  model.covariance = read_covariance(tables, model);
  if (model.covariance)
    if (const std::string other = other_values(*model.covariance, model); !other.empty()) {
      notes.push_back(
          other + ", so results have no error band; raceway calibrate calculates a new covariance");
      model.covariance.reset();
    }
  return {.model = std::move(read.model),
          .source = source,
          .text = std::move(text),
          .catalogue = std::move(read.catalogue),
          .written = std::move(read.written),
          .defaults = tables.defaults(),
          .notes = notes_of(record::note::odd_value, std::move(notes), {.file = source}),
          .columns = std::move(columns),
          .sensor = std::move(sensor),
          .files = tables.files().list()};
}

ModelFile parse_model(std::string text, const std::string& source, std::vector<NamedFile> held) {
  ModelTables tables(text, source, std::move(held));
  try {
    const std::vector<UsedDefault> marked = marked_values(tables.root(), text);
    ModelFile file = model_of_tables(tables, std::move(text));
    file.defaults.insert(file.defaults.begin(), marked.begin(), marked.end());
    return file;
  } catch (const MissingKey& first) {
    Names missing = missing_keys_of_bearing(tables);
    for (std::string& one : missing_keys_of_friction(tables)) missing.push_back(std::move(one));
    if (missing.size() < 2) throw;
    throw text::InputError(fmt::format("{}\nIn total, {} keys are missing (raceway new BEARING -o "
                                       "FILE writes a complete model):\n  {}",
                                       first.what(), missing.size(), fmt::join(missing, "\n  ")),
                           first.place);
  }
}

ModelFile read_model(const std::string& path) {
  bool marked = false;
  std::string text = text::read_text(path, &marked);
  ModelFile file = parse_model(std::move(text), text::input_name(path));
  if (marked) file.text.insert(0, text::utf8_mark);
  return file;
}

}  // namespace raceway::files
