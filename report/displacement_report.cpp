#include <cmath>

#include "record/units.h"
#include "report/detail/model_facts.h"
#include "report/detail/report_document.h"
#include "report/report.h"
#include "report/report_columns.h"
#include "results/kinematic_results.h"
#include "results/shaft_results.h"

namespace raceway::report {
namespace {

/// The law between the speeds too, closer together near standstill, where it is steep.
text::json curve_json(const shaft::KinematicLaw& law) {
  constexpr int steps = 200;
  text::json curve = text::json::array();
  for (int k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const double speed = law.lowest_speed + (law.highest_speed - law.lowest_speed) * share * share;
    curve.push_back({speed / rpm, evaluate(law, speed).displacement / um});
  }
  return curve;
}

}  // namespace

std::string displacement_report(const std::string& model_file, const model::Model& model,
                                std::span<const shaft::ShaftPoint> points,
                                std::span<const shaft::ShaftPrediction> predictions,
                                const LawOfReport& law, const std::vector<std::string>& warnings,
                                const std::vector<ModelOfPage>& facts,
                                const model::Findings& findings) {
  Document document("displacement");
  document.add("assumed", model_facts(facts));
  document.add("model", model_file);
  // The rows stand below, as columns: as JSON each takes some kB.
  document.add_text("results", results::displacement_json(model, {}, {}, nullptr, findings));
  const bearing::Arrangement& arrangement = model.shaft->arrangement;
  text::json places = text::json::array();
  for (std::size_t i = 0; i < arrangement.bearings().size(); ++i)
    places.push_back(results::bearing_place(arrangement, i));
  document.add("places", std::move(places));
  document.add("warnings", warnings);
  document.add("judged", model::warnings_of(findings));
  document.add("law_statement", law.statement);
  if (law.fit) {
    document.add_text("law", results::kinematic_law_json(*law.fit, law.statement, std::nullopt));
    document.add("law_curve", curve_json(law.fit->law));
  }

  ReportColumns rows(points.size());
  const auto add = [&](const std::string& name, auto value) {
    std::vector<double> values;
    for (std::size_t k = 0; k < points.size(); ++k) values.push_back(value(k));
    rows.add(name, std::move(values));
  };
  add("speed_rpm", [&](std::size_t k) { return points[k].speed / rpm; });
  add("external_load_N", [&](std::size_t k) { return points[k].external_load; });
  add("temperature_C", [&](std::size_t k) { return celsius(points[k].temperature); });
  for (const results::DisplacementColumn& c : results::displacement_columns(arrangement))
    add(c.name, [&](std::size_t k) { return c.value(predictions[k]); });
  if (law.fit) {
    const auto at = [&](std::size_t k) {
      return evaluate(law.fit->law, points[k].speed).displacement;
    };
    add("law_displacement_um", [&](std::size_t k) { return at(k) / um; });
    add("law_residual_um",
        [&](std::size_t k) { return (at(k) - predictions[k].displacement) / um; });
    for (std::size_t k = 0; k < points.size(); ++k)
      if (points[k].speed == law.fit->speed_of_max_abs) rows.keep(k);
  }
  document.add_text("rows", rows.json());
  return report_page(document.text());
}

}  // namespace raceway::report
