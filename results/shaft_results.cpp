#include "results/shaft_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "record/units.h"
#include "results/detail/model_objects.h"
#include "shaft/shaft_balance.h"
#include "text/detail/csv_text.h"
#include "text/printable.h"
#include "text/units.h"

namespace raceway::results {
namespace {

using bearing::Arrangement;
using bearing::Side;

std::string_view side_name(Side side) { return side == Side::front ? "front" : "rear"; }

/// A number of one bearing, by the name of its column or key, in SI.
struct BearingColumn {
  const char* name;
  double (*value)(const shaft::ShaftPrediction& p, std::size_t i);
};

constexpr BearingColumn bearing_columns[] = {
    {"axial_load_N",
     [](const auto& p, std::size_t i) { return p.equilibrium.bearings[i].axial_load; }},
    {"inner_contact_angle_deg",
     [](const auto& p, std::size_t i) {
       return p.equilibrium.bearings[i].ball.inner_contact_angle;
     }},
    {"outer_contact_angle_deg",
     [](const auto& p, std::size_t i) {
       return p.equilibrium.bearings[i].ball.outer_contact_angle;
     }},
    {"inner_load_N",
     [](const auto& p, std::size_t i) { return p.equilibrium.bearings[i].ball.inner_load; }},
    {"outer_load_N",
     [](const auto& p, std::size_t i) { return p.equilibrium.bearings[i].ball.outer_load; }},
    {"inner_contact_pressure_MPa",
     [](const auto& p, std::size_t i) { return p.equilibrium.bearings[i].inner_pressure; }},
    {"outer_contact_pressure_MPa",
     [](const auto& p, std::size_t i) { return p.equilibrium.bearings[i].outer_pressure; }},
    {"friction_torque_Nmm", [](const auto& p, std::size_t i) { return p.friction[i].torque; }},
    {"power_loss_W", [](const auto& p, std::size_t i) { return p.friction[i].power_loss; }},
    {"inner_ring_heat_W", [](const auto& p, std::size_t i) { return p.heat[i].inner; }},
    {"outer_ring_heat_W", [](const auto& p, std::size_t i) { return p.heat[i].outer; }}};

/// A number of the whole shaft.
struct ShaftColumn {
  const char* name;
  double (*value)(const shaft::ShaftPrediction& p);
};

constexpr ShaftColumn shaft_columns[] = {
    {"axial_displacement_um", [](const auto& p) { return p.displacement; }},
    {"front_force_N", [](const auto& p) { return p.equilibrium.front_force; }},
    {"rear_force_N", [](const auto& p) { return p.equilibrium.rear_force; }},
    {"axial_stiffness_N_um", [](const auto& p) { return p.equilibrium.axial_stiffness; }},
    {"friction_torque_Nmm", [](const auto& p) { return p.torque; }},
    {"power_loss_W", [](const auto& p) { return p.power_loss; }},
    {"axial_position_um", [](const auto& p) { return p.equilibrium.position; }}};

double in_unit(double value, std::string_view name) { return value / text::column_unit(name); }

text::json arrangement_json(const model::Model& model) {
  const Arrangement a = shaft::mounted_arrangement(model);
  const bearing::LiftOff free = lift_off(a);
  return {{"preload_N", a.preload()},
          {"front_displacement_um", a.displacement(Side::front) / um},
          {"rear_displacement_um", a.displacement(Side::rear) / um},
          {"front_lift_off_load_N", free.front},
          {"rear_lift_off_load_N", free.rear}};
}

text::json row_json(const model::Model& model, const shaft::ShaftPoint& point,
                    const shaft::ShaftPrediction& p) {
  text::json row = {{"speed_rpm", point.speed / rpm},
                    {"external_load_N", point.external_load},
                    {"temperature_C", celsius(point.temperature)}};
  for (const ShaftColumn& c : shaft_columns) row[c.name] = in_unit(c.value(p), c.name);
  const Arrangement& a = model.shaft->arrangement;
  text::json bearings = text::json::array();
  // Without balance there are no bearings to speak of.
  for (std::size_t i = 0; i < p.equilibrium.bearings.size(); ++i) {
    const bearing::BearingInSet& b = p.equilibrium.bearings[i];
    text::json one = {{"place", bearing_place(a, i)}};
    for (const BearingColumn& c : bearing_columns) one[c.name] = in_unit(c.value(p, i), c.name);
    one["displacement_um"] = b.displacement / um;
    one["axial_stiffness_N_um"] = b.axial_stiffness / N_per_um;
    one["centrifugal_force_N"] = b.ball.centrifugal_force;
    one["gyroscopic_moment_Nmm"] = b.ball.gyroscopic_moment / N_mm;
    one["minimum_load_N"] = b.minimum_load;
    one["lost_contact"] = b.lost();
    one["friction"] = friction_json(model, p.friction[i]);
    bearings.push_back(std::move(one));
  }
  row["bearings"] = std::move(bearings);
  bearing::SolveReport report = p.equilibrium.report;
  report.status = p.status();
  row["report"] = report_json(report);
  return row;
}

}  // namespace

std::string bearing_place(const Arrangement& a, std::size_t i) {
  const Side side = a.side(i);
  return fmt::format("{}_{}", side_name(side), (side == Side::front ? i : i - a.front_count()) + 1);
}

std::vector<DisplacementColumn> displacement_columns(const Arrangement& a) {
  std::vector<DisplacementColumn> columns;
  for (const ShaftColumn& c : shaft_columns)
    columns.push_back(
        {c.name, [c](const shaft::ShaftPrediction& p) { return in_unit(c.value(p), c.name); }});
  for (std::size_t i = 0; i < a.bearings().size(); ++i)
    for (const BearingColumn& c : bearing_columns)
      columns.push_back({fmt::format("{}_{}", bearing_place(a, i), c.name),
                         [c, i](const shaft::ShaftPrediction& p) {
                           return p.equilibrium.report.converged() ? in_unit(c.value(p, i), c.name)
                                                                   : unset;
                         }});
  return columns;
}

std::string displacement_text(const model::Model& model, std::span<const shaft::ShaftPoint> points,
                              std::span<const shaft::ShaftPrediction> predictions,
                              std::string_view model_text, const BandOfResult* band) {
  const std::vector<DisplacementColumn> columns = displacement_columns(model.shaft->arrangement);
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "# Shaft position against speed: {}\n# raceway {}\n",
                 text::printable(model.name), RACEWAY_VERSION);
  text::append_model(out, model_text);
  fmt::format_to(put, "speed_rpm,");
  for (const DisplacementColumn& c : columns) fmt::format_to(put, "{},", c.name);
  const std::vector<std::string> of_band = band ? band->names : std::vector<std::string>();
  for (const std::string& name : of_band) {
    text::append_text(out, name);
    out.push_back(',');
  }
  fmt::format_to(put, "status\n");
  for (std::size_t k = 0; k < points.size(); ++k) {
    text::append_value(out, points[k].speed / rpm);
    out.push_back(',');
    for (const DisplacementColumn& c : columns) {
      text::append_value(out, c.value(predictions[k]));
      out.push_back(',');
    }
    for (std::size_t c = 0; c < of_band.size(); ++c) {
      text::append_value(out, in_unit(band->half_widths[k * of_band.size() + c], of_band[c]));
      out.push_back(',');
    }
    fmt::format_to(put, "{}\n", bearing::name(predictions[k].status()));
  }
  return fmt::to_string(out);
}

std::string displacement_json(const model::Model& model, std::span<const shaft::ShaftPoint> points,
                              std::span<const shaft::ShaftPrediction> predictions,
                              const BandOfResult* band, const model::Findings& findings) {
  text::json rows = text::json::array();
  for (std::size_t k = 0; k < points.size(); ++k) {
    rows.push_back(row_json(model, points[k], predictions[k]));
    if (band) add_band(rows.back(), *band, k);
  }
  text::json document = {{"bearing", model.name},
                         {"arrangement", arrangement_json(model)},
                         {"rows", std::move(rows)},
                         {"judgement", judgement_json(findings)}};
  if (band) document["band"] = band_json(*band);
  return text::text(std::move(document));
}

std::string shaft_solve_json(const model::Model& model, const shaft::ShaftPoint& point,
                             const shaft::ShaftPrediction& prediction, const BandOfResult* band,
                             const model::Findings& findings) {
  text::json document = {{"bearing", model.name}, {"arrangement", arrangement_json(model)}};
  document.update(row_json(model, point, prediction));
  document["judgement"] = judgement_json(findings);
  add_band(document, band);
  return text::text(std::move(document));
}

}  // namespace raceway::results
