#include <fmt/format.h>

#include <cmath>

#include "model/prediction.h"
#include "record/digits.h"
#include "record/units.h"
#include "report/detail/model_facts.h"
#include "report/detail/report_document.h"
#include "report/detail/report_rows.h"
#include "report/report.h"
#include "report/report_columns.h"
#include "results/shaft_results.h"
#include "shaft/shaft_balance.h"
#include "text/error.h"
#include "text/units.h"

namespace raceway::report {
namespace {

/// Seven digits, which is what rows of a report have.
double short_number(double value) {
  return std::isfinite(value) ? record::with_digits(value, 7) : unset;
}

text::json state_json(const model::Model& model, const bearing::OperatingPoint& point,
                      const model::FrictionPrediction& prediction) {
  const bearing::Bearing& bearing = bearing_of(model, prediction);
  text::json azimuth = text::json::array(), inner_angle = text::json::array(),
             outer_angle = text::json::array(), inner_load = text::json::array(),
             outer_load = text::json::array(), inner_pressure = text::json::array(),
             outer_pressure = text::json::array();
  for (const bearing::BallEquilibrium& b : prediction.equilibrium->balls) {
    azimuth.push_back(short_number(b.azimuth / degree));
    inner_angle.push_back(short_number(b.inner_contact_angle / degree));
    outer_angle.push_back(short_number(b.outer_contact_angle / degree));
    inner_load.push_back(short_number(b.inner_load));
    outer_load.push_back(short_number(b.outer_load));
    inner_pressure.push_back(
        short_number(bearing.contact(bearing::Race::inner).peak_pressure(b.inner_load) / MPa));
    outer_pressure.push_back(
        short_number(bearing.contact(bearing::Race::outer).peak_pressure(b.outer_load) / MPa));
  }
  return {{"speed_rpm", short_number(point.speed / rpm)},
          {"axial_load_N", point.axial_load},
          {"radial_load_N", point.radial_load},
          {"temperature_C", celsius(point.temperature)},
          {"azimuth_deg", azimuth},
          {"inner_contact_angle_deg", inner_angle},
          {"outer_contact_angle_deg", outer_angle},
          {"inner_load_N", inner_load},
          {"outer_load_N", outer_load},
          {"inner_pressure_MPa", inner_pressure},
          {"outer_pressure_MPa", outer_pressure}};
}

/// Names of columns that add up to the torque.
text::json part_names(const model::Model& model) {
  text::json parts = text::json::array();
  if (model.shaft) {
    const bearing::Arrangement& arrangement = model.shaft->arrangement;
    for (std::size_t i = 0; i < arrangement.bearings().size(); ++i)
      parts.push_back(results::bearing_place(arrangement, i) + "_friction_torque_Nmm");
    return parts;
  }
  for (const std::string& name : model::torque_parts(model)) parts.push_back(name + "_Nmm");
  return parts;
}

std::string rows_json(const friction::StribeckTable& table) {
  ReportColumns rows(table.friction_moment.size());
  const auto add = [&](const std::string& name, auto value) {
    std::vector<double> values;
    for (std::size_t i = 0; i < table.friction_moment.size(); ++i) values.push_back(value(i));
    rows.add(name, std::move(values));
  };
  add("speed_rpm", [&](std::size_t i) { return table.point(i).speed / rpm; });
  add("axial_load_N", [&](std::size_t i) { return table.point(i).axial_load; });
  add("radial_load_N", [&](std::size_t i) { return table.point(i).radial_load; });
  add("temperature_C", [&](std::size_t i) { return celsius(table.point(i).temperature); });
  add("friction_torque_Nmm", [&](std::size_t i) { return table.friction_moment[i] / N_mm; });
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    add(table.columns[c],
        [&](std::size_t i) { return table.row(i)[c] / text::column_unit(table.columns[c]); });
  return rows.json();
}

/// The readings of the first measured channel; a torque is that of one bearing of the rig, as the
/// curves are.
void add_measured(Document& document, record::Record record, const model::Rig& rig) {
  record::Column* readings = nullptr;
  for (record::Column& c : record.columns)
    if (!readings && c.channel->role == record::Role::measured) readings = &c;
  if (!readings) return;
  if (*readings->channel == record::friction_torque)
    for (double& v : readings->values) v /= model::rig_torque(rig, 1.0);
  Document part("measured");
  const ReportRows rows(record, *readings->channel, rows_read(record, *readings->channel));
  rows.finish(part);
  document.add_text("measured", part.text());
  document.add("data", record.source);
}

}  // namespace

std::string table_report(const std::string& model_file, const model::Model& model,
                         const friction::StribeckTable& table, const BearingStates& states,
                         const record::Record* measured, const std::vector<ModelOfPage>& facts,
                         const std::vector<std::string>& warnings) {
  if (model.bearing.rollers())
    throw text::InputError(model_file +
                           ": --report is not possible for cylindrical roller bearings, because "
                           "the page draws balls; use --output, --json or --plot");
  Document document("table");
  document.add("assumed", model_facts(facts));
  document.add("results", {{"model", model_file},
                           {"bearing", model.name},
                           {"parts", part_names(model)},
                           {"contact_angle_deg", model.bearing.geometry().contact_angle / degree}});
  document.add("judged", warnings);
  document.add_text("rows", rows_json(table));
  text::json list = text::json::array();
  for (const auto& [point, prediction] : states)
    list.push_back(state_json(model, point, prediction));
  document.add("states", std::move(list));
  if (model.shaft) document.add("preload_N", shaft::mounted_arrangement(model).preload());
  if (measured) add_measured(document, *measured, model.rig);
  return report_page(document.text());
}

}  // namespace raceway::report
