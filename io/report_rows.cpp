#include "io/report_rows.h"

#include "fit/misfit_map.h"

namespace raceway::io {
namespace {

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

json map_json(const fit::MisfitMap& map, double unit) {
  json cells = json::array();
  for (const fit::MisfitCell& c : map.cells)
    cells.push_back({{"across", c.across},
                     {"up", c.up},
                     {"rows", c.rows},
                     {"bias", c.bias / unit},
                     {"sigmas", c.sigmas},
                     {"significant", c.significant}});
  return {{"up_variable", fit::name(map.up_variable)},
          {"across", axis_json(map.across)},
          {"up", axis_json(map.up)},
          {"needed_sigmas", map.needed_sigmas},
          {"cells", cells}};
}

}  // namespace

ReportRows::ReportRows(const fit::DataSet& data, std::vector<double> std)
    : data_(data),
      quantity_(fit::text_of(data.quantity)),
      std_(std::move(std)),
      columns_(data.rows.size()) {
  add("line", [](const fit::Row& r) { return r.line; });
  if (data.runs.size() > 1) add("run", [](const fit::Row& r) { return r.run; });
  if (known(&fit::Row::time)) add("time_s", [](const fit::Row& r) { return r.time; });
  add_input("speed_rpm", [](const fit::Row& r) { return r.point.speed / rpm; });
  add_input("axial_load_N", [](const fit::Row& r) { return r.point.axial_load; });
  // The displacement of a shaft is computed under thrust alone, without the lubricant.
  if (data.quantity == fit::Quantity::friction_torque) {
    add_input("radial_load_N",
              [](const fit::Row& r) { return value_of(fit::Variable::radial_load, r); });
    add_input("temperature_C", [](const fit::Row& r) { return celsius(r.point.temperature); });
  }
  if (known(&fit::Row::inner_ring_temperature))
    add_input("inner_ring_temperature_C",
              [](const fit::Row& r) { return celsius(r.inner_ring_temperature); });
  if (known(&fit::Row::outer_ring_temperature))
    add_input("outer_ring_temperature_C",
              [](const fit::Row& r) { return celsius(r.outer_ring_temperature); });
  if (known(&fit::Row::preload))
    add_input("preload_N", [](const fit::Row& r) { return r.preload; });
  std::vector<double> measured;
  for (const fit::Row& row : data.rows) measured.push_back(row.measured);
  add_readings("measured", measured);
  add_readings("std", std_);
}

std::string ReportRows::add_readings(const std::string& name, const std::vector<double>& values) {
  std::vector<double> in_unit = values;
  for (double& v : in_unit) v /= quantity_.factor;
  std::string column = name + "_" + std::string(quantity_.key_unit);
  columns_.add(column, std::move(in_unit));
  return column;
}

void ReportRows::add_models(const std::vector<Predicted>& models, Document& document) {
  json list = json::array();
  for (const Predicted& model : models) {
    const std::string column =
        add_readings("predicted_" + std::to_string(list.size()), model.readings);
    const fit::Comparison comparison = fit::compare(model.readings, data_);
    for (const fit::RowError& e : comparison.worst) columns_.keep(e.row);
    std::vector<double> std;
    for (const fit::RowError& e : comparison.errors) std.push_back(std_[e.row]);
    list.push_back({{"name", model.name},
                    {"column", column},
                    {"rmse", comparison.rmse / quantity_.factor},
                    {"map", map_json(fit::misfit_map(comparison, data_, std), quantity_.factor)}});
  }
  document.add("models", dump(list));
}

void ReportRows::finish(Document& document) const {
  document.add("quantity", dump({{"name", quantity_.name},
                                 {"in_words", quantity_.in_words},
                                 {"unit", quantity_.key_unit}}));
  document.add("inputs", dump(inputs_));
  document.add("runs", dump(data_.runs));
  document.add("rows", columns_.json());
}

}  // namespace raceway::io
