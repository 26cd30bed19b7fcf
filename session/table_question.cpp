#include "session/table_question.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

#include "files/table_exchange.h"
#include "files/table_file.h"
#include "fit/problem.h"
#include "model/prediction.h"
#include "results/results.h"
#include "session/bands.h"
#include "session/contact_statement.h"
#include "session/judged.h"
#include "session/table_columns.h"

namespace raceway::session {
namespace {

std::string why(const model::Model& model, const bearing::OperatingPoint& point,
                bearing::SolveStatus status) {
  if (model.shaft || status != bearing::SolveStatus::not_finite)
    return std::string(bearing::name(status));
  return why_not_converged(model, model::predict_friction(model, point, true));
}

/// At most `most` values of an axis, evenly spread, both ends among them.
std::vector<double> spread(const std::vector<double>& values, std::size_t most) {
  if (values.size() <= most) return values;
  std::vector<double> few;
  for (std::size_t i = 0; i < most; ++i)
    few.push_back(values[i * (values.size() - 1) / (most - 1)]);
  return few;
}

}  // namespace

TablePlan plan_table(Messages& messages, const files::ModelFile& file,
                     const TableQuestion& question) {
  TablePlan plan{.axes = table_axes(messages, file, question.axes, question.wording),
                 .columns = table_columns(file.model)};
  if (question.band)
    for (std::string& name : band_columns(file.model)) plan.columns.push_back(std::move(name));
  return plan;
}

TableAnswer make_table(const files::ModelFile& file, const TableQuestion& question, TablePlan plan,
                       const std::function<void(double)>& progress,
                       const std::atomic<bool>* cancelled) {
  const auto fill = [&](auto points, auto out) {
    if (cancelled && cancelled->load()) throw fit::Cancelled();
    fill_table_line(file.model, points, out);
    if (question.band) fill_band(file.model, *question.band, points, out);
  };
  TableAnswer answer{.table = friction::build_stribeck_table(plan.axes, std::move(plan.columns),
                                                             fill, progress, question.slab),
                     .band = question.band};
  answer.findings = judge(file.model, answer.table);
  return answer;
}

std::string TableAnswer::json(const model::Model& model) const {
  const results::BandOfResult of_band{
      .parameters = band ? band->fitted() : std::vector<std::string>(),
      .names = {},
      .half_widths = {}};
  return results::table_json(model, table, band ? &of_band : nullptr, findings);
}

std::string TableAnswer::text(const files::ModelFile& file, const std::string& format,
                              const std::function<void(double)>& progress) const {
  if (format == "plain") return files::plain_table_text(table);
  if (format == "modelica") return files::modelica_table_text(table, file.model.name);
  return files::table_text(table, file.model.name, file.text, progress);
}

std::vector<std::string> TableAnswer::notes(const model::Model& model) const {
  std::vector<std::string> lines = model::notes_of(findings);
  if (table.points() > 0)  // at the highest speed of the first loads
    if (std::string balls = balls_statement(model, table.point(table.axes.speed.size() - 1));
        !balls.empty())
      lines.push_back(std::move(balls));
  return lines;
}

TableFailures failures(const model::Model& model, const friction::StribeckTable& table) {
  struct Failure {
    std::size_t points = 0, first = 0;
  };
  std::map<std::pair<bool, bearing::SolveStatus>, Failure> found;  // with a torque or without
  for (std::size_t i = 0; i < table.points(); ++i) {
    if (table.status[i] == bearing::SolveStatus::converged) continue;
    const bool torque = !std::isnan(table.friction_moment[i]);
    ++found.try_emplace({torque, table.status[i]}, Failure{0, i}).first->second.points;
  }
  TableFailures result;
  for (const auto& [kind, failure] : found) {
    const bearing::OperatingPoint p = table.point(table.first() + failure.first);
    const auto& [torque, status] = kind;
    result.lines.push_back(
        fmt::format("{} of {} points have no {}: {}; the first is at {:.6g} rpm, {:.6g} N axial, "
                    "{:.6g} N radial",
                    failure.points, table.points(),
                    torque ? "equilibrium (the friction torque does not depend on it)" : "value",
                    why(model, p, status), p.speed / rpm, p.axial_load, p.radial_load));
    if (!torque) result.without_torque = true;
  }
  return result;
}

report::BearingStates states_to_draw(const model::Model& model, const friction::TableAxes& grid) {
  if (model.shaft) return {};
  std::vector<bearing::OperatingPoint> points;
  for (const double radial : spread(grid.radial_load, 3))
    for (const double axial : spread(grid.axial_load, 4))
      for (const double speed : spread(grid.speed, 25))
        points.push_back({.speed = speed,
                          .axial_load = axial,
                          .radial_load = radial,
                          .temperature = grid.temperature.front()});
  std::vector<model::FrictionPrediction> predictions(points.size());
  model::predict_sweep(model, points, predictions, true);
  report::BearingStates states;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (predictions[i].equilibrium && predictions[i].equilibrium->report.converged())
      states.emplace_back(points[i], std::move(predictions[i]));
  return states;
}

}  // namespace raceway::session
