#include "report/spindle_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/rings.h"
#include "record/digits.h"
#include "record/units.h"
#include "report/detail/model_facts.h"
#include "report/detail/report_document.h"
#include "report/report_columns.h"
#include "shaft/shaft_balance.h"
#include "spindle/loaded_shaft.h"
#include "spindle/sets_at_speed.h"

namespace raceway::report {
namespace {

using spindle::Inputs;
using spindle::Moment;

constexpr int place_digits = 6;

double drawn_mm(double metres) { return record::with_digits(metres / mm, place_digits); }

/// Of all cells one number each.
text::json of_each_cell(const std::vector<spindle::FieldCell>& cells,
                        double (*value)(const spindle::FieldCell&)) {
  text::json list = text::json::array();
  for (const spindle::FieldCell& c : cells) list.push_back(value(c));
  return list;
}

text::json cells_json(const std::vector<spindle::FieldCell>& cells) {
  text::json parts = text::json::array();
  for (const spindle::FieldCell& c : cells) parts.push_back(c.part);
  return {{"part", std::move(parts)},
          {"start_mm", of_each_cell(cells, [](const auto& c) { return drawn_mm(c.start); })},
          {"end_mm", of_each_cell(cells, [](const auto& c) { return drawn_mm(c.end); })},
          {"inner_radius_mm",
           of_each_cell(cells, [](const auto& c) { return drawn_mm(c.inner_radius); })},
          {"outer_radius_mm",
           of_each_cell(cells, [](const auto& c) { return drawn_mm(c.outer_radius); })}};
}

/// Places and sizes of the bearings, as they are drawn into the section.
text::json drawn_bearings(const model::Model& model) {
  const model::Spindle& s = *model.spindle;
  const bearing::Arrangement& a = model.shaft->arrangement;
  const std::vector<model::Rings> rings = model::rings_of(s, a);
  text::json list = text::json::array();
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const model::Rings& r = rings[i];
    text::json one{{"label", results::bearing_label(model, i)},
                   {"position_mm", drawn_mm(r.position)},
                   {"width_mm", drawn_mm(r.width)},
                   {"bore_mm", drawn_mm(r.bore)},
                   {"outer_diameter_mm", drawn_mm(r.outer_diameter)},
                   {"inner_ring_shoulder_mm", drawn_mm(r.inner_shoulder)},
                   {"outer_ring_shoulder_mm", drawn_mm(r.outer_shoulder)}};
    if (i < a.bearings().size()) {
      const bearing::BearingGeometry& g = a.bearings()[i].bearing->geometry();
      one["ball_diameter_mm"] = drawn_mm(g.ball_diameter);
      one["pitch_diameter_mm"] = drawn_mm(g.pitch_diameter);
      one["contact_angle_deg"] = record::with_digits(g.contact_angle / degree, place_digits);
      one["pressed_rearwards"] = spindle::presses_rearwards(a, i);
    } else {
      const bearing::RollerGeometry& g = s.rollers[i - a.bearings().size()].bearing.geometry();
      one["roller_diameter_mm"] = drawn_mm(g.roller_diameter);
      one["roller_length_mm"] = drawn_mm(g.roller_length);
      one["pitch_diameter_mm"] = drawn_mm(g.pitch_diameter);
    }
    list.push_back(std::move(one));
  }
  return list;
}

text::json section_json(const model::Model& model, std::span<const DrawnField> fields) {
  const model::Spindle& s = *model.spindle;
  text::json moments = text::json::array();
  for (const DrawnField& f : fields)
    moments.push_back({{"time_s", f.time},
                       {"speed_rpm", record::with_digits(f.speed / rpm, place_digits)},
                       {"temperature_C", of_each_cell(f.cells, [](const auto& c) {
                          return std::round(100.0 * celsius(c.temperature)) / 100.0;
                        })}});
  text::json sensors = text::json::array();
  for (const model::ThermometerPlace& t : s.sensors)
    if (std::isfinite(t.position) && std::isfinite(t.radius))
      sensors.push_back({{"name", t.name},
                         {"position_mm", drawn_mm(t.position)},
                         {"radius_mm", drawn_mm(t.radius)}});
  text::json section{{"cells", cells_json(fields.front().cells)},
                     {"bearings", drawn_bearings(model)},
                     {"sensors", std::move(sensors)},
                     {"flange",
                      {{"position_mm", drawn_mm(s.housing.flange)},
                       {"length_mm", drawn_mm(s.housing.flange_length)}}},
                     {"moments", std::move(moments)}};
  text::json channels = text::json::array();
  for (const model::Coolant& c : s.channels())
    channels.push_back({{"start_mm", drawn_mm(c.start)},
                        {"end_mm", drawn_mm(c.end)},
                        {"diameter_mm", drawn_mm(c.diameter)},
                        {"width_mm", drawn_mm(c.channel_width)},
                        {"depth_mm", drawn_mm(c.channel_depth)},
                        {"pitch_mm", drawn_mm(c.pitch)}});
  if (!channels.empty()) section["channels"] = std::move(channels);
  return section;
}

/// Of the sets, and roller bearings behind them.
std::size_t bearings_on_shaft(const model::Model& model) {
  return model.shaft->arrangement.bearings().size() + model.spindle->rollers.size();
}

/// What both pages have of a model.
void add_parts(Document& document, const ModelOfPage& of, std::span<const DrawnField> fields,
               const std::string& mesh_text) {
  const model::Model& model = of.model;
  document.add("assumed", model_facts({of}));
  document.add("model", of.file);
  document.add("mesh", mesh_text);
  document.add("network", model.spindle->network.has_value());
  document.add("has_coolant", model.spindle->coolant.has_value());
  text::json bearings = text::json::array(), sensors = text::json::array();
  if (!model.spindle->network)
    for (std::size_t i = 0; i < bearings_on_shaft(model); ++i)
      bearings.push_back(results::bearing_label(model, i));
  for (const model::ThermometerPlace& t : model.spindle->sensors) sensors.push_back(t.name);
  document.add("bearings", std::move(bearings));
  document.add("sensors", std::move(sensors));
  if (!fields.empty() && !fields.front().cells.empty())
    document.add("section", section_json(model, fields));
}

/// Where there is no steady state.
Moment no_moment() {
  Moment m;
  m.heat = {unset, unset, unset, unset, unset, unset};
  return m;
}

/// Columns of run.csv, row by row.
class MomentColumns {
 public:
  explicit MomentColumns(std::size_t rows) : columns_(rows) {}

  void add(const model::Model& model, const Inputs& inputs, const Moment& moment) {
    std::vector<results::RunColumn> row = results::run_columns(model, inputs, moment);
    // The page draws the axial force of every bearing.
    for (const model::RollerOnShaft& r : model.spindle->rollers)
      row.push_back({r.name + "_force_N", 0.0});
    if (values_.empty()) {
      for (const results::RunColumn& c : row) names_.push_back(c.name);
      values_.resize(row.size());
    }
    for (std::size_t k = 0; k < row.size(); ++k) values_[k].push_back(row[k].value);
  }
  ReportColumns& finish() {
    for (std::size_t k = 0; k < names_.size(); ++k)
      columns_.add_course(std::move(names_[k]), std::move(values_[k]));
    return columns_;
  }

 private:
  ReportColumns columns_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> values_;
};

/// What is set over time, beside the speed; not what is left to the model throughout.
void add_inputs(Document& document, ReportColumns& columns, const spindle::DrawnRun& drawn) {
  text::json names = text::json::array({"speed_rpm"});
  const auto add = [&](const char* name, auto value) {
    std::vector<double> values;
    for (const spindle::ProfileRow& row : drawn.rows) values.push_back(value(row.inputs));
    if (std::all_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) return;
    columns.add_course(name, std::move(values));
    names.push_back(name);
  };
  add("coolant_on", [](const Inputs& i) { return i.coolant_on ? 1.0 : 0.0; });
  add("ambient_temperature_C", [](const Inputs& i) { return celsius(i.ambient_temperature); });
  add("machine_temperature_C", [](const Inputs& i) { return celsius(i.machine_temperature); });
  add("coolant_inlet_temperature_C", [](const Inputs& i) { return celsius(i.coolant_inlet); });
  add("motor_heat_W", [](const Inputs& i) { return i.motor_heat; });
  add("motor_power_W", [](const Inputs& i) { return i.motor_power; });
  add("axial_load_N", [](const Inputs& i) { return i.axial_load; });
  add("radial_load_N", [](const Inputs& i) { return i.radial_load; });
  add("moment_Nm", [](const Inputs& i) { return i.moment; });
  add("belt_force_N", [](const Inputs& i) { return i.belt_force; });
  document.add("inputs", std::move(names));
}

/// Of each bearing what no column of run.csv has.
void add_bearings(ReportColumns& columns, const model::Model& model,
                  std::span<const results::SteadyState> states) {
  if (model.spindle->network) return;
  const auto add = [&](const std::string& name, auto value) {
    std::vector<double> values;
    for (const results::SteadyState& s : states) values.push_back(value(s));
    columns.add(name, std::move(values));
  };
  const std::size_t balls = model.shaft->arrangement.bearings().size();
  for (std::size_t i = 0; i < bearings_on_shaft(model); ++i) {
    const std::string label = results::bearing_label(model, i);
    if (i < balls)
      add(label + "_friction_W", [&](const results::SteadyState& s) {
        return i < s.moment.bearings.size() ? s.moment.bearings[i].power : unset;
      });
    const auto of_set = [&](const std::string& name, auto value) {
      add(label + name, [&](const results::SteadyState& s) {
        return i < s.bearings.size() ? value(s.bearings[i]) : unset;
      });
    };
    using Set = const bearing::BearingInSet&;
    of_set("_inner_contact_angle_deg", [](Set b) { return b.ball.inner_contact_angle / degree; });
    of_set("_outer_contact_angle_deg", [](Set b) { return b.ball.outer_contact_angle / degree; });
    of_set("_inner_load_N", [](Set b) { return b.ball.inner_load; });
    of_set("_outer_load_N", [](Set b) { return b.ball.outer_load; });
    of_set("_inner_contact_pressure_MPa", [](Set b) { return b.inner_pressure / MPa; });
    of_set("_outer_contact_pressure_MPa", [](Set b) { return b.outer_pressure / MPa; });
    of_set("_axial_stiffness_N_um", [](Set b) { return b.axial_stiffness / N_per_um; });
  }
}

}  // namespace

std::string spindle_run_report(const ModelOfPage& of, const std::string& programme,
                               std::size_t rows_asked, const spindle::Run& run,
                               const spindle::DrawnRun& drawn, std::span<const DrawnField> fields,
                               const results::MeshEstimate& mesh, const std::string& mesh_text,
                               const model::Findings& findings,
                               const results::Assumptions& assumptions) {
  Document document("spindle_run");
  document.add("judged", model::warnings_of(findings));
  add_parts(document, of, fields, mesh_text);
  document.add("programme", programme);
  const spindle::Run head{.report = run.report,
                          .highest_front_force = run.highest_front_force,
                          .time_of_highest_force = run.time_of_highest_force};
  document.add_text("results",
                    results::spindle_run_json(of.model, {}, head, mesh, findings, assumptions));
  document.add("rows_asked", rows_asked);
  document.add("rows_reached", run.moments.size() - (run.has_end ? 1 : 0));
  document.add("ended_at_s", run.end.time);
  MomentColumns moments(drawn.moments.size());
  std::vector<double> time, hours;
  for (std::size_t k = 0; k < drawn.moments.size(); ++k) {
    moments.add(of.model, drawn.rows[k].inputs, drawn.moments[k]);
    time.push_back(drawn.moments[k].time);
    hours.push_back(drawn.moments[k].time / 3600.0);
  }
  ReportColumns& columns = moments.finish();
  columns.add("time_s", std::move(time));
  columns.add("hours", std::move(hours));
  add_inputs(document, columns, drawn);
  document.add_text("rows", columns.json());
  return report_page(document.text());
}

std::string spindle_steady_report(const ModelOfPage& of,
                                  std::span<const results::SteadyState> states,
                                  std::span<const DrawnField> fields,
                                  const results::MeshEstimate& mesh, const std::string& mesh_text,
                                  const model::Findings& findings,
                                  const results::Assumptions& assumptions) {
  Document document("spindle_steady");
  document.add("judged", model::warnings_of(findings));
  add_parts(document, of, fields, mesh_text);
  document.add_text("results",
                    results::spindle_steady_json(of.model, {}, mesh, findings, assumptions));
  if (of.model.shaft) document.add("preload_N", shaft::mounted_arrangement(of.model).preload());
  document.add("coolant_on", states.front().inputs.coolant_on);
  text::json reports = text::json::array();
  for (const results::SteadyState& s : states)
    reports.push_back({{"status", spindle::name(s.report.status)},
                       {"in_words", spindle::words(s.report.status)}});
  document.add("reports", std::move(reports));
  MomentColumns moments(states.size());
  std::vector<double> stiffness;
  for (const results::SteadyState& s : states) {
    moments.add(of.model, s.inputs, s.report.converged() ? s.moment : no_moment());
    stiffness.push_back(s.axial_stiffness / N_per_um);
  }
  ReportColumns& columns = moments.finish();
  columns.add("axial_stiffness_N_um", std::move(stiffness));
  add_bearings(columns, of.model, states);
  document.add_text("rows", columns.json());
  return report_page(document.text());
}

}  // namespace raceway::report
