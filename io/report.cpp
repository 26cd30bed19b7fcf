#include "io/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "fit/misfit_map.h"
#include "fit/verdict_model.h"
#include "io/column_unit.h"
#include "io/diagnosis_results.h"
#include "io/error.h"
#include "io/report_columns.h"
#include "io/report_document.h"
#include "io/report_template.h"
#include "io/results.h"

namespace raceway::io {
namespace {

using json = nlohmann::ordered_json;

/// What one model says of all rows.
struct Predicted {
  std::string name;
  std::vector<double> readings;  // [N m], NaN where there is none
};

/// In the unit of the file, from the edge of a range.
double in_file_unit(fit::Variable variable, double value) {
  if (variable == fit::Variable::speed) return value / rpm;
  return variable == fit::Variable::temperature ? celsius(value) : value;
}

json axis_json(const std::vector<fit::ErrorRange>& ranges) {
  json list = json::array();
  for (const fit::ErrorRange& r : ranges) {
    if (r.variable == fit::Variable::run)
      list.push_back({{"run", r.run}});
    else
      list.push_back(
          {{"from", in_file_unit(r.variable, r.from)}, {"to", in_file_unit(r.variable, r.to)}});
  }
  return list;
}

json map_json(const fit::MisfitMap& map) {
  json cells = json::array();
  for (const fit::MisfitCell& c : map.cells)
    cells.push_back({{"across", c.across},
                     {"up", c.up},
                     {"rows", c.rows},
                     {"bias", c.bias / N_mm},
                     {"sigmas", c.sigmas},
                     {"significant", c.significant}});
  return {{"up_variable", fit::name(map.up_variable)},
          {"across", axis_json(map.across)},
          {"up", axis_json(map.up)},
          {"needed_sigmas", map.needed_sigmas},
          {"cells", cells}};
}

/// Rows of a data set as columns: what was set, what was read, its noise, what models say.
class RowTable {
 public:
  /// `std` of each row [N m], NaN where not known.
  RowTable(const fit::DataSet& data, std::vector<double> std)
      : data_(data), std_(std::move(std)), columns_(data.rows.size()) {
    add("line", [](const fit::Row& r) { return r.line; });
    if (data.runs.size() > 1) add("run", [](const fit::Row& r) { return r.run; });
    if (known(&fit::Row::time)) add("time_s", [](const fit::Row& r) { return r.time; });
    add("speed_rpm", [](const fit::Row& r) { return r.point.speed / rpm; });
    add("axial_load_N", [](const fit::Row& r) { return r.point.axial_load; });
    add("radial_load_N", [](const fit::Row& r) { return value_of(fit::Variable::radial_load, r); });
    add("temperature_C", [](const fit::Row& r) { return celsius(r.point.temperature); });
    if (known(&fit::Row::inner_ring_temperature))
      add("inner_ring_temperature_C",
          [](const fit::Row& r) { return celsius(r.inner_ring_temperature); });
    if (known(&fit::Row::outer_ring_temperature))
      add("outer_ring_temperature_C",
          [](const fit::Row& r) { return celsius(r.outer_ring_temperature); });
    if (known(&fit::Row::preload)) add("preload_N", [](const fit::Row& r) { return r.preload; });
    add("measured_Nmm", [](const fit::Row& r) { return r.measured / N_mm; });
    columns_.add("std_Nmm", in_Nmm(std_));
  }

  void add_torque(const std::string& name, const std::vector<double>& torque) {
    columns_.add(name, in_Nmm(torque));
  }

  /// Columns `predicted_0_Nmm`, ... and, for each, where the model errs on the plan.
  void add_models(const std::vector<Predicted>& models, Document& document) {
    json list = json::array();
    for (const Predicted& model : models) {
      const std::string column = "predicted_" + std::to_string(list.size()) + "_Nmm";
      add_torque(column, model.readings);
      const fit::Comparison comparison = fit::compare(model.readings, data_);
      for (const fit::RowError& e : comparison.worst) columns_.keep(e.row);
      std::vector<double> std;
      for (const fit::RowError& e : comparison.errors) std.push_back(std_[e.row]);
      list.push_back({{"name", model.name},
                      {"column", column},
                      {"rmse", comparison.rmse / N_mm},
                      {"map", map_json(fit::misfit_map(comparison, data_, std))}});
    }
    document.add("models", dump(list));
  }

  void finish(Document& document) const {
    document.add("runs", dump(data_.runs));
    document.add("rows", columns_.json());
  }

 private:
  template <typename Value>
  void add(const std::string& name, Value value) {
    std::vector<double> values;
    values.reserve(data_.rows.size());
    for (const fit::Row& r : data_.rows) values.push_back(static_cast<double>(value(r)));
    columns_.add(name, std::move(values));
  }
  [[nodiscard]] bool known(double fit::Row::*member) const {
    return std::any_of(data_.rows.begin(), data_.rows.end(),
                       [&](const fit::Row& r) { return !std::isnan(r.*member); });
  }
  static std::vector<double> in_Nmm(std::vector<double> torque) {
    for (double& v : torque) v /= N_mm;
    return torque;
  }

  const fit::DataSet& data_;
  std::vector<double> std_;
  ReportColumns columns_;
};

/// A number of each row of the data, from the errors of a comparison, which may stand in another
/// order: rows are known by their line.
template <typename Value>
std::vector<double> by_row(const fit::Comparison& comparison, const fit::DataSet& data,
                           Value value) {
  std::unordered_map<int, double> by_line;
  for (const fit::RowError& e : comparison.errors) by_line[e.line] = value(e);
  std::vector<double> values;
  for (const fit::Row& row : data.rows) {
    const auto found = by_line.find(row.line);
    values.push_back(found == by_line.end() ? unset : found->second);
  }
  return values;
}

std::vector<double> predicted_rows(const fit::Comparison& comparison, const fit::DataSet& data) {
  return by_row(comparison, data, [](const fit::RowError& e) { return e.predicted; });
}

/// Standard deviation of each row from a noise model, which is in the order of the comparison.
std::vector<double> noise_rows(const fit::NoiseModel& noise, const fit::Comparison& comparison,
                               const fit::DataSet& data) {
  return by_row(comparison, data, [&](const fit::RowError& e) {
    return noise.whitening.std()[static_cast<Eigen::Index>(e.row)];
  });
}

/// Only the rows that were used: a diagnosis thins large files and leaves out what has no balance.
fit::DataSet used_rows(const fit::DataSet& data, const std::vector<double>& predicted) {
  fit::DataSet used = data;
  used.rows.clear();
  for (std::size_t i = 0; i < data.rows.size(); ++i)
    if (!std::isnan(predicted[i])) used.rows.push_back(data.rows[i]);
  return used;
}

json effect_names(const std::vector<fit::EffectShare>& effects) {
  json list = json::array();
  for (std::size_t k = 0; k < effects.size(); ++k)
    list.push_back({{"id", effects[k].id}, {"column", "effect_" + std::to_string(k) + "_Nmm"}});
  return list;
}

}  // namespace

bool report_available() { return !report_template().empty(); }

std::string report_page(const std::string& document) {
  constexpr std::string_view mark = "@DOCUMENT@";
  const std::string_view page = report_template();
  if (page.empty())
    throw InputError(
        "this program was built without reports (-DRACEWAY_REPORT=OFF); build it with Node and npm "
        "and -DRACEWAY_REPORT=ON");
  const std::size_t at = page.find(mark);
  std::string text;
  text.reserve(page.size() + document.size() + document.size() / 16);
  text += page.substr(0, at);
  // In JSON these occur within strings only, where the escape means the same character.
  for (const char c : document) {
    if (c == '<')
      text += "\\u003c";
    else if (c == '>')
      text += "\\u003e";
    else if (c == '&')
      text += "\\u0026";
    else
      text += c;
  }
  return text += page.substr(at + mark.size());
}

std::string comparison_report(const std::vector<std::string>& model_files,
                              const std::vector<fit::Comparison>& comparisons,
                              const fit::DataSet& data) {
  Document document("compare");
  document.add("results", comparison_json(model_files, comparisons, data));
  const fit::Noise& noise = comparisons.front().noise;
  const bool by_row =
      noise.source == fit::NoiseSource::declared || noise.source == fit::NoiseSource::regression;
  std::vector<double> std;
  for (const fit::Row& row : data.rows) std.push_back(by_row ? row.std : noise.rms);
  RowTable rows(data, std);
  std::vector<Predicted> models;
  for (std::size_t i = 0; i < comparisons.size(); ++i)
    models.push_back({model_files[i], predicted_rows(comparisons[i], data)});
  rows.add_models(models, document);
  rows.finish(document);
  return report_page(document.text());
}

std::string diagnosis_report(const std::string& model_file, const fit::Model& model,
                             const fit::DataSet& all, const fit::Diagnosis& d) {
  Document document("diagnose");
  document.add("results", diagnosis_json(model_file, all, d));
  const fit::DataSet data = used_rows(all, predicted_rows(d.baseline, all));
  const std::vector<double> base = predicted_rows(d.baseline, data);
  RowTable rows(data, noise_rows(d.noise, d.baseline, data));
  std::vector<Predicted> models{{"refitted, nothing added", base}};
  const std::optional<fit::VerdictModel> verdict = fit::verdict_model(model, data, d);
  if (verdict) {
    std::string ids;
    for (const fit::EffectShare& e : verdict->effects) ids += (ids.empty() ? "" : " and ") + e.id;
    models.push_back({"with " + ids, verdict->readings});
  }
  rows.add_models(models, document);
  if (verdict) {
    document.add("effects_of_verdict", dump(effect_names(verdict->effects)));
    for (std::size_t k = 0; k < verdict->effects.size(); ++k)
      rows.add_torque("effect_" + std::to_string(k) + "_Nmm", verdict->effects[k].torque);
    rows.add_torque("base_with_effects_Nmm", verdict->base);
  }
  rows.finish(document);
  return report_page(document.text());
}

std::string add_report(const std::string& model_file, const fit::DataSet& all,
                       const fit::AddResult& r) {
  Document document("add");
  document.add("results", add_json(model_file, all, r));
  document.add("noise_rms", dump(r.noise.rms / N_mm));
  const fit::DataSet data = used_rows(all, predicted_rows(r.before, all));
  RowTable rows(data, noise_rows(r.noise, r.before, data));
  rows.add_models({{"before, refitted", predicted_rows(r.before, data)},
                   {"after", predicted_rows(r.after, data)}},
                  document);
  rows.finish(document);
  return report_page(document.text());
}

namespace {

json state_json(const fit::Model& model, const bearing::OperatingPoint& point,
                const fit::FrictionPrediction& prediction) {
  const bearing::Bearing& bearing = prediction.bearing ? *prediction.bearing : model.bearing;
  json azimuth = json::array(), inner_angle = json::array(), outer_angle = json::array(),
       inner_load = json::array(), outer_load = json::array(), inner_pressure = json::array(),
       outer_pressure = json::array();
  for (const bearing::BallEquilibrium& b : prediction.equilibrium->balls) {
    azimuth.push_back(b.azimuth / degree);
    inner_angle.push_back(b.inner_contact_angle / degree);
    outer_angle.push_back(b.outer_contact_angle / degree);
    inner_load.push_back(b.inner_load);
    outer_load.push_back(b.outer_load);
    inner_pressure.push_back(bearing.contact(bearing::Race::inner).peak_pressure(b.inner_load) /
                             MPa);
    outer_pressure.push_back(bearing.contact(bearing::Race::outer).peak_pressure(b.outer_load) /
                             MPa);
  }
  return {{"speed_rpm", point.speed / rpm},
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

}  // namespace

std::string table_report(const std::string& model_file, const fit::Model& model,
                         const friction::StribeckTable& table, const BearingStates& states,
                         const fit::DataSet* measured) {
  Document document("table");
  json parts = json::array({"load_Nmm", "viscous_Nmm"});
  for (const effects::Effect& e : model.effects)
    parts.push_back(std::string(e.description->id) + "_Nmm");
  document.add("results",
               dump({{"model", model_file},
                     {"bearing", model.name},
                     {"parts", parts},
                     {"contact_angle_deg", model.bearing.geometry().contact_angle / degree}}));
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
        [&](std::size_t i) { return table.row(i)[c] / column_unit(table.columns[c]); });
  document.add("rows", rows.json());
  json list = json::array();
  for (const auto& [point, prediction] : states)
    list.push_back(state_json(model, point, prediction));
  document.add("states", dump(list));
  if (measured != nullptr) {
    fit::DataSet of_one_bearing = *measured;
    for (fit::Row& row : of_one_bearing.rows) row.measured /= model.rig.bearings;
    Document part("measured");
    const RowTable measured_rows(of_one_bearing, std::vector<double>(measured->rows.size(), unset));
    measured_rows.finish(part);
    document.add("measured", part.text());
    document.add("data", dump(measured->source));
  }
  return report_page(document.text());
}

}  // namespace raceway::io
