#include "io/results.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "fit/quantity.h"
#include "io/column_unit.h"
#include "io/json_text.h"

namespace raceway::io {
namespace {

json effect_page(const effects::Description& d) {
  json needs = json::array();
  for (const effects::Need need : d.needs) needs.push_back(effects::text(need));
  json parameters = json::object();
  for (const effects::Parameter& p : d.parameters)
    parameters[std::string(p.name)] = {{"unit", p.unit},
                                       {"initial", p.initial},
                                       {"lower", p.lower},
                                       {"upper", p.upper},
                                       {"usual_lower", p.plausible_lower},
                                       {"usual_upper", p.plausible_upper},
                                       {"no_effect_at", p.neutral}};
  json measured = json::array();
  for (const fit::Quantity quantity :
       {fit::Quantity::friction_torque, fit::Quantity::axial_displacement})
    if (d.moves(fit::subject_of(quantity))) measured.push_back(fit::text_of(quantity).name);
  return {{"id", d.id},
          {"title", d.title},
          {"acts_at", d.step()},
          {"acts_on", measured},
          {"mechanism", d.mechanism},
          {"formula", d.formula},
          {"source", d.source},
          {"parameters", parameters},
          {"needs", needs},
          {"needs_equilibrium", d.needs_equilibrium},
          {"confused_with", d.confused_with}};
}

}  // namespace

std::string solve_json(const fit::Model& model, const bearing::OperatingPoint& point,
                       const bearing::BearingEquilibrium& e,
                       const fit::FrictionPrediction& friction, const friction::HeatSplit& heat) {
  json balls = json::array();
  for (const bearing::BallEquilibrium& b : e.balls) {
    balls.push_back({{"azimuth_deg", b.azimuth / degree},
                     {"inner_contact_angle_deg", b.inner_contact_angle / degree},
                     {"outer_contact_angle_deg", b.outer_contact_angle / degree},
                     {"inner_load_N", b.inner_load},
                     {"outer_load_N", b.outer_load},
                     {"centrifugal_force_N", b.centrifugal_force},
                     {"gyroscopic_moment_Nmm", b.gyroscopic_moment / N_mm}});
  }
  json matrix = json::array();
  for (int i = 0; i < 5; ++i) {
    json row = json::array();
    for (int j = 0; j < 5; ++j) row.push_back(e.stiffness(i, j));
    matrix.push_back(row);
  }
  const auto& u = e.displacement;
  return text({{"bearing", model.name},
               {"speed_rpm", point.speed / rpm},
               {"axial_load_N", point.axial_load},
               {"radial_load_N", point.radial_load},
               {"temperature_C", celsius(point.temperature)},
               {"axial_displacement_um", u[0] / um},
               {"radial_displacement_um", std::hypot(u[1], u[2]) / um},
               {"tilt_y_mrad", u[3] / mrad},
               {"tilt_z_mrad", u[4] / mrad},
               {"balls", balls},
               {"stiffness",
                {{"axial_N_um", e.stiffness(0, 0) / N_per_um},
                 {"radial_N_um", e.stiffness(1, 1) / N_per_um},
                 {"matrix", matrix}}},
               {"friction", friction_json(model, friction)},
               {"friction_torque_Nmm", friction.torque / N_mm},
               {"power_loss_W", friction.power_loss},
               {"inner_ring_heat_W", heat.inner},
               {"outer_ring_heat_W", heat.outer},
               {"report", report_json(e.report)}});
}

std::string table_json(const fit::Model& model, const friction::StribeckTable& table) {
  json rows = json::array();
  for (std::size_t i = 0; i < table.friction_moment.size(); ++i) {
    const bearing::OperatingPoint p = table.point(i);
    json row = {{"speed_rpm", p.speed / rpm},
                {"axial_load_N", p.axial_load},
                {"radial_load_N", p.radial_load},
                {"temperature_C", celsius(p.temperature)},
                {"friction_torque_Nmm", table.friction_moment[i] / N_mm}};
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      row[table.columns[c]] = table.row(i)[c] / column_unit(table.columns[c]);
    row["status"] = bearing::name(table.status[i]);
    rows.push_back(std::move(row));
  }
  return text({{"bearing", model.name}, {"rows", rows}});
}

std::string calibration_json(const fit::Calibration& c) {
  json parameters = json::object();
  for (const fit::FittedParameter& p : c.parameters)
    parameters[p.name] = {{"value", p.value},
                          {"std", p.std},
                          {"unit", p.unit},
                          {"start", p.start},
                          {"lower", p.lower},
                          {"upper", p.upper},
                          {"at_bound", p.at_bound != fit::Bound::none},
                          {"identifiable", p.identifiable}};
  json correlation = json::array();
  for (Eigen::Index i = 0; i < c.correlation.rows(); ++i) {
    json row = json::array();
    for (Eigen::Index j = 0; j < c.correlation.cols(); ++j) row.push_back(c.correlation(i, j));
    correlation.push_back(row);
  }
  const fit::QuantityText q = fit::text_of(c.quantity);
  // The digits of the model file, all of them.
  return exact_text({{"parameters", parameters},
                     {"correlation", correlation},
                     {"rows", c.rows},
                     {"rows_not_predicted", c.rows_not_predicted},
                     {"degrees_of_freedom", c.degrees_of_freedom},
                     {"reduced_chi_square", c.reduced_chi_square},
                     {"quantity", q.name},
                     {"unit", q.key_unit},
                     {"rmse_before", c.rmse_before / q.factor},
                     {"rmse", c.rmse_after / q.factor},
                     {"messages", c.messages},
                     {"report", {{"status", fit::name(c.status)}, {"iterations", c.iterations}}}});
}

namespace {

struct RangeUnit {
  const char* unit;
  double factor;
  double offset;
};

RangeUnit range_unit(fit::Variable v) {
  switch (v) {
    case fit::Variable::speed:
      return {"rpm", rpm, 0.0};
    case fit::Variable::temperature:
      return {"C", 1.0, celsius_zero};
    case fit::Variable::run:
      return {"", 1.0, 0.0};
    default:
      return {"N", 1.0, 0.0};
  }
}

json one_comparison(const std::string& file, const fit::Comparison& c) {
  const fit::QuantityText q = fit::text_of(c.quantity);
  json where = json::array();
  for (const fit::ErrorRange& r : c.where) {
    const RangeUnit u = range_unit(r.variable);
    json range = {{"variable", fit::name(r.variable)}};
    if (r.variable == fit::Variable::run) {
      range["from"] = range["to"] = r.run;
    } else {
      range["from"] = (r.from - u.offset) / u.factor;
      range["to"] = (r.to - u.offset) / u.factor;
    }
    range["unit"] = u.unit;
    range["rows"] = r.rows;
    range["rmse"] = r.rmse / q.factor;
    range["bias"] = r.bias / q.factor;
    where.push_back(range);
  }
  json worst = json::array();
  for (const fit::RowError& r : c.worst)
    worst.push_back({{"line", r.line},
                     {"predicted", r.predicted / q.factor},
                     {"measured", r.measured / q.factor},
                     {"residual", r.residual / q.factor},
                     {"sigmas", r.sigmas}});
  return {
      {"model", file},
      {"quantity", q.name},
      {"unit", q.key_unit},
      {"rows", c.rows},
      {"rows_not_predicted", c.rows_not_predicted},
      {"rmse", c.rmse / q.factor},
      {"mae", c.mae / q.factor},
      {"max_abs", c.max_abs / q.factor},
      {"bias", c.bias / q.factor},
      {"fit_percent", c.fit_percent},
      {"noise", {{"rms", c.noise.rms / q.factor}, {"source", fit::name(c.noise.source)}}},
      {"lack_of_fit", {{"statistic", c.lack_of_fit.statistic}, {"p_value", c.lack_of_fit.p_value}}},
      {"statement", c.statement},
      {"where", where},
      {"worst_rows", worst}};
}

}  // namespace

std::string comparison_json(const std::vector<std::string>& model_files,
                            const std::vector<fit::Comparison>& comparisons,
                            const fit::DataSet& data) {
  json documents = json::array();
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    json document = one_comparison(model_files[i], comparisons[i]);
    document["data"] = data.source;
    documents.push_back(document);
  }
  if (documents.size() == 1) return text(documents[0]);
  return text({{"models", documents}});
}

std::string bearings_json(const std::vector<CatalogueBearing>& rows) {
  json bearings = json::array();
  for (const CatalogueBearing& r : rows)
    bearings.push_back({{"name", r.full_name()},
                        {"bore_mm", r.geometry.bore / mm},
                        {"outer_diameter_mm", r.geometry.outer_diameter / mm},
                        {"pitch_diameter_mm", r.geometry.pitch_diameter / mm},
                        {"ball_diameter_mm", r.geometry.ball_diameter / mm},
                        {"ball_count", r.geometry.ball_count},
                        {"contact_angle_deg", r.geometry.contact_angle / degree},
                        {"static_load_rating_N", r.geometry.static_load_rating}});
  return text({{"bearings", bearings}});
}

std::string effect_json(const effects::Description& effect) { return text(effect_page(effect)); }

std::string effects_json(std::span<const effects::Description> all) {
  json pages = json::array();
  for (const effects::Description& effect : all) pages.push_back(effect_page(effect));
  return text({{"effects", pages}});
}

std::string check_json(const CheckSummary& s) {
  const bool torque = s.quantity == "friction_torque";
  json columns = json::array();
  for (const ColumnSummary& c : s.columns)
    columns.push_back({{"name", c.name}, {"from", c.lower}, {"to", c.upper}, {"levels", c.levels}});
  json effects = json::array();
  for (const CheckSummary::Testable& t : s.effects)
    effects.push_back({{"id", t.id},
                       {"testable", t.missing.empty()},
                       {"missing", t.missing},
                       {"hard_without", t.levels}});
  json parameters = json::array();
  for (const CheckSummary::Free& f : s.free_parameters)
    parameters.push_back({{"name", f.name}, {"identifiable", f.identifiable}});
  return text({{"model", s.model_name},
               {"quantity", s.quantity},
               {"rows", s.rows},
               {"runs", s.runs},
               {"unit", torque ? "Nmm" : "um"},
               {"noise", {{"rms", s.noise / (torque ? N_mm : um)}, {"source", s.noise_source}}},
               {"columns", columns},
               {"free_parameters", parameters},
               {"effects", effects},
               {"defaults", s.defaults},
               {"notes", s.notes}});
}

}  // namespace raceway::io
