#include "results/spindle_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/rings.h"
#include "record/units.h"
#include "results/detail/model_objects.h"
#include "text/detail/csv_text.h"
#include "text/detail/json_text.h"
#include "text/printable.h"

namespace raceway::results {
namespace {

using spindle::Inputs;
using spindle::Moment;

text::json row_json(const std::vector<RunColumn>& columns) {
  text::json row = text::json::object();
  for (const RunColumn& c : columns) row[c.name] = c.value;
  return row;
}

text::json mesh_json(const MeshEstimate& mesh) {
  if (!mesh.known()) return nullptr;
  return {{"other_cells", mesh.other_cells},
          {"speed_rpm", mesh.speed / rpm},
          {"axial_displacement_um", mesh.displacement / um},
          {"inner_ring_temperature_K", mesh.inner_ring_rise},
          {"front_force_N", mesh.front_force}};
}

text::json report_of(const spindle::Report& report, const MeshEstimate& mesh) {
  return {{"status", spindle::name(report.status)},
          {"message", report.message},
          {"steps", report.steps},
          {"rejected", report.rejected},
          {"energy_error", report.energy_error},
          {"cells", mesh.cells},
          {"mesh_estimate", mesh_json(mesh)}};
}

void put_title(fmt::memory_buffer& out, const model::Model& model, std::string_view what,
               std::string_view model_text) {
  fmt::format_to(std::back_inserter(out), "# {} of a spindle: {}\n# raceway {}\n", what,
                 text::printable(model.spindle->name), RACEWAY_VERSION);
  text::append_model(out, model_text);
}

void put_header(fmt::memory_buffer& out, const std::vector<RunColumn>& columns) {
  for (const RunColumn& c : columns) {
    if (&c != columns.data()) out.push_back(',');
    text::append_text(out, c.name);
  }
}

text::json seat_json(const spindle::SeatState& seat) {
  return {{"pressure_MPa", seat.pressure / MPa},
          {"gap_um", seat.gap / um},
          {"conductance_W_m2K", seat.conductance}};
}

text::json seats_json(const model::Model& model, std::span<const spindle::SeatsOfBearing> seats) {
  text::json list = text::json::array();
  for (std::size_t k = 0; k < seats.size(); ++k)
    list.push_back({{"bearing", bearing_label(model, k)},
                    {"on_shaft", seat_json(seats[k].inner)},
                    {"in_housing", seat_json(seats[k].outer)}});
  return list;
}

text::json surfaces_json(std::span<const spindle::SurfaceState> surfaces) {
  text::json list = text::json::array();
  for (const spindle::SurfaceState& s : surfaces)
    list.push_back({{"name", s.name},
                    {"area_mm2", s.area / (mm * mm)},
                    {"conductance_W_m2K", s.conductance},
                    {"pressure_MPa", s.pressure / MPa},
                    {"heat_W", s.heat}});
  return list;
}

text::json flow_json(const spindle::ChannelFlow& flow) {
  return {{"velocity_m_s", flow.velocity},
          {"reynolds_number", flow.reynolds},
          {"film_W_m2K", flow.film},
          {"pressure_drop_bar", flow.pressure_drop / spindle::bar},
          {"throttle_pressure_drop_bar", flow.throttle_drop / spindle::bar}};
}

text::json circuits_json(const model::Model& model, const SteadyState& s) {
  text::json list = text::json::array();
  for (std::size_t k = 0; k < s.channels.size(); ++k) {
    const spindle::CircuitState& now = s.moment.circuits[k];
    text::json circuit{{"name", circuit_name(model, k)},
                       {"inlet_temperature_C", celsius(now.inlet)},
                       {"outlet_temperature_C", celsius(now.outlet)},
                       {"heat_W", now.heat}};
    if (s.channels[k]) circuit.update(flow_json(*s.channels[k]));
    list.push_back(std::move(circuit));
  }
  return list;
}

text::json shaft_json(std::span<const spindle::ShaftPlace> shaft) {
  text::json list = text::json::array();
  for (const spindle::ShaftPlace& place : shaft)
    list.push_back(
        {{"position_mm", place.position / mm}, {"axial_displacement_um", place.displacement / um}});
  return list;
}

text::json stress_json(const spindle::Stress& s) {
  return {{"radius_mm", s.radius / mm},
          {"axial_MPa", s.axial / MPa},
          {"hoop_MPa", s.hoop / MPa},
          {"radial_MPa", s.radial / MPa},
          {"von_mises_MPa", s.von_mises() / MPa}};
}

text::json section_json(const model::Model& model, const spindle::SectionStress& s) {
  using Part = spindle::SectionStress::Part;
  const bool of_bearing = s.bearing >= 0;
  return {
      {"part", s.part == Part::shaft        ? "shaft"
               : s.part == Part::inner_ring ? "inner_ring"
                                            : "outer_ring"},
      {"bearing", of_bearing ? text::json(bearing_label(model, static_cast<std::size_t>(s.bearing)))
                             : text::json(nullptr)},
      {"start_mm", s.start / mm},
      {"end_mm", s.end / mm}};
}

text::json stresses_json(const model::Model& model,
                         std::span<const spindle::SectionStress> sections) {
  const spindle::SectionStress* const most = largest_stress(sections);
  text::json largest = section_json(model, *most);
  largest.update(stress_json(most->largest()));
  text::json list = text::json::array();
  for (const spindle::SectionStress& s : sections) {
    text::json section = section_json(model, s), at = text::json::array();
    for (const spindle::Stress& place : s.at) at.push_back(stress_json(place));
    section["at"] = std::move(at);
    list.push_back(std::move(section));
  }
  return {{"largest", std::move(largest)}, {"sections", std::move(list)}};
}

text::json json_of(const Assumptions& assumptions) {
  text::json most = text::json::array();
  for (const Assumption& a : assumptions.most)
    most.push_back({{"name", a.name},
                    {"value", a.value},
                    {"spread", a.spread},
                    {"displacement_at_less_um", a.low / um},
                    {"displacement_at_more_um", a.high / um}});
  return {{"speed_rpm", assumptions.speed / rpm},
          {"axial_displacement_um", assumptions.displacement / um},
          {"assumed", assumptions.assumed},
          {"most", std::move(most)}};
}

void put_row(fmt::memory_buffer& out, const std::vector<RunColumn>& columns) {
  for (const RunColumn& c : columns) {
    if (&c != columns.data()) out.push_back(',');
    text::append_value(out, c.value);
  }
}

}  // namespace

const spindle::SectionStress* largest_stress(std::span<const spindle::SectionStress> sections) {
  const auto most =
      std::max_element(sections.begin(), sections.end(), [](const auto& a, const auto& b) {
        return a.largest().von_mises() < b.largest().von_mises();
      });
  return most == sections.end() ? nullptr : &*most;
}

std::vector<RunColumn> run_columns(const model::Model& model, const Inputs& inputs,
                                   const Moment& m) {
  std::vector<RunColumn> list{{"speed_rpm", inputs.speed / rpm}};
  if (!model.spindle->network) {
    list.push_back({"axial_displacement_um", m.displacement / um});
    list.push_back({"kinematic_displacement_um", m.kinematic_displacement / um});
    list.push_back({"thermal_displacement_um", m.thermal_displacement() / um});
    list.push_back({"front_force_N", m.front_force});
    list.push_back({"rear_force_N", m.rear_force});
  }
  // A state that was not found has no heat, not a heat of 0.
  const bool found = !m.bearings.empty() || !m.sensors.empty();
  const auto add_heat = [&](const char* name, double heat) {
    list.push_back({name, found ? heat : unset});
  };
  add_heat("friction_power_W", m.heat.friction);
  const bool has_band = model.law == friction::FrictionLaw::table && model.table->has_band();
  if (has_band) add_heat("friction_power_band_W", m.heat.friction_band);
  add_heat("drive_heat_W", m.heat.drive);
  add_heat("heat_to_coolant_W", m.heat.coolant);
  add_heat("heat_to_air_W", m.heat.air);
  add_heat("heat_to_machine_W", m.heat.machine);
  add_heat("heat_stored_W", m.heat.stored);
  const std::vector<model::ThermometerPlace>& sensors = model.spindle->sensors;
  for (std::size_t k = 0; k < sensors.size(); ++k)
    list.push_back(
        {sensors[k].name + "_temperature_C", k < m.sensors.size() ? celsius(m.sensors[k]) : unset});
  if (model.spindle->network) return list;
  const std::size_t balls = model.shaft->arrangement.bearings().size();
  for (std::size_t k = 0; k < balls + model.spindle->rollers.size(); ++k) {
    const spindle::BearingState b = k < m.bearings.size() ? m.bearings[k] : spindle::BearingState{};
    const std::string label = bearing_label(model, k);
    list.push_back({label + "_inner_ring_temperature_C", celsius(b.inner_ring_temperature)});
    list.push_back({label + "_outer_ring_temperature_C", celsius(b.outer_ring_temperature)});
    if (k < balls) list.push_back({label + "_force_N", b.force});
    if (k < balls && has_band) {
      list.push_back({label + "_friction_W", b.power});
      list.push_back({label + "_friction_band_W", b.power_band});
    }
    list.push_back({label + "_radial_force_N", b.radial_force});
    if (k < balls) continue;
    list.push_back({label + "_clearance_um", b.clearance / um});
    list.push_back({label + "_friction_W", b.power});
  }
  const auto is_sensor = [&](std::string_view name) {
    return std::any_of(sensors.begin(), sensors.end(),
                       [&](const auto& s) { return s.name == name; });
  };
  for (std::size_t k = 0; k < model.spindle->heat.size(); ++k)
    list.push_back(
        {model.spindle->heat[k].name + "_heat_W", k < m.sources.size() ? m.sources[k] : unset});
  if (model.spindle->coolant && !is_sensor("coolant_outlet"))
    list.push_back({"coolant_outlet_temperature_C", celsius(m.coolant_outlet)});
  for (std::size_t k = 0; k < model.spindle->circuits.size(); ++k) {
    const std::string& name = model.spindle->circuits[k].name;
    const spindle::CircuitState now =
        k + 1 < m.circuits.size() ? m.circuits[k + 1] : spindle::CircuitState{.heat = unset};
    if (!is_sensor(name + "_outlet"))
      list.push_back({name + "_outlet_temperature_C", celsius(now.outlet)});
    list.push_back({"heat_to_" + name + "_W", now.heat});
  }
  return list;
}

std::string circuit_name(const model::Model& model, std::size_t circuit) {
  return circuit == 0 ? "coolant" : model.spindle->circuits[circuit - 1].name;
}

std::string bearing_label(const model::Model& model, std::size_t bearing) {
  const std::size_t front = model.shaft->arrangement.front_count();
  const std::size_t sets = model.shaft->arrangement.bearings().size();
  return model::bearing_names(front, sets - front, model.spindle->rollers).at(bearing);
}

std::string spindle_run_text(const model::Model& model,
                             std::span<const spindle::ProfileRow> profile, const spindle::Run& run,
                             std::string_view model_text) {
  fmt::memory_buffer out;
  put_title(out, model, "Run", model_text);
  const auto put = std::back_inserter(out);
  fmt::format_to(put,
                 "# the inputs of a row apply from the previous row to the time of this row\n");
  fmt::format_to(put, "time_s,");
  put_header(out, run_columns(model, {}, {}));
  out.push_back('\n');
  for (std::size_t k = 0; k < run.moments.size(); ++k) {
    text::append_value(out, run.moments[k].time);
    out.push_back(',');
    put_row(out, run_columns(model, profile[k].inputs, run.moments[k]));
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

std::string spindle_run_json(const model::Model& model,
                             std::span<const spindle::ProfileRow> profile, const spindle::Run& run,
                             const MeshEstimate& mesh, const model::Findings& findings,
                             const Assumptions& assumptions) {
  text::json rows = text::json::array();
  for (std::size_t k = 0; k < run.moments.size(); ++k) {
    text::json row{{"time_s", run.moments[k].time}};
    row.update(row_json(run_columns(model, profile[k].inputs, run.moments[k])));
    rows.push_back(std::move(row));
  }
  text::json document(
      {{"spindle", model.spindle->name},
       {"report", report_of(run.report, mesh)},
       {"highest_front_force",
        {{"force_N", run.highest_front_force}, {"time_s", run.time_of_highest_force}}},
       {"rows_asked", profile.size() - (run.has_end ? 1 : 0)},
       {"rows_reached", run.moments.size() - (run.has_end ? 1 : 0)},
       {"judgement", judgement_json(findings)},
       {"rows", std::move(rows)}});
  if (assumptions.known()) document["assumptions"] = json_of(assumptions);
  return text::text(document);
}

std::string spindle_steady_text(const model::Model& model, std::span<const SteadyState> states,
                                std::string_view model_text) {
  fmt::memory_buffer out;
  put_title(out, model, "Steady states", model_text);
  put_header(out, run_columns(model, {}, {}));
  fmt::format_to(std::back_inserter(out), ",axial_stiffness_N_um,status\n");
  for (const SteadyState& s : states) {
    put_row(out, run_columns(model, s.inputs, s.moment));
    out.push_back(',');
    text::append_value(out, s.axial_stiffness / N_per_um);
    fmt::format_to(std::back_inserter(out), ",{}\n", spindle::name(s.report.status));
  }
  return fmt::to_string(out);
}

std::string spindle_steady_json(const model::Model& model, std::span<const SteadyState> states,
                                const MeshEstimate& mesh, const model::Findings& findings,
                                const Assumptions& assumptions) {
  text::json rows = text::json::array();
  for (const SteadyState& s : states) {
    text::json row = row_json(run_columns(model, s.inputs, s.moment));
    row["axial_stiffness_N_um"] = s.axial_stiffness / N_per_um;
    if (!s.channels.empty() && s.channels.front()) row["coolant"] = flow_json(*s.channels.front());
    if (s.channels.size() > 1) row["circuits"] = circuits_json(model, s);
    if (!s.seats.empty()) {
      row["seats"] = seats_json(model, s.seats);
      row["surfaces"] = surfaces_json(s.surfaces);
      row["shaft"] = shaft_json(s.shaft);
      row["stress"] = stresses_json(model, s.stress);
    }
    row["report"] = report_of(
        s.report, mesh.speed == s.inputs.speed ? mesh : MeshEstimate{.cells = mesh.cells});
    rows.push_back(std::move(row));
  }
  text::json document({{"spindle", model.spindle->name},
                       {"judgement", judgement_json(findings)},
                       {"steady", std::move(rows)}});
  if (assumptions.known()) document["assumptions"] = json_of(assumptions);
  return text::text(document);
}

std::string spindle_field_text(std::span<const spindle::FieldCell> cells, std::string_view name) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  fmt::format_to(put,
                 "# Temperatures of a spindle: {}\n# raceway {}\n"
                 "position_mm,radius_mm,part,temperature_C\n",
                 text::printable(name), RACEWAY_VERSION);
  for (const spindle::FieldCell& c : cells) {
    text::append_value(out, 0.5 * (c.start + c.end) / mm);
    out.push_back(',');
    text::append_value(out, 0.5 * (c.inner_radius + c.outer_radius) / mm);
    fmt::format_to(put, ",{},", c.part);
    text::append_value(out, celsius(c.temperature));
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace raceway::results
