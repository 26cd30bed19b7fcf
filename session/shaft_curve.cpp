#include "session/shaft_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "report/report.h"
#include "results/shaft_results.h"
#include "session/judged.h"
#include "session/law_statement.h"
#include "session/open_input.h"
#include "session/operating_point.h"
#include "session/shaft_answers.h"
#include "text/error.h"
#include "text/number_range.h"

namespace raceway::session {
namespace {

bool has_failed(const shaft::ShaftPrediction& p) {
  return p.status() != bearing::SolveStatus::converged;
}

/// The kinematic law of the curve, as fit-law finds it.
report::LawOfReport law_of(const ShaftCurve& shown) {
  std::vector<shaft::DisplacementPoint> curve;
  for (std::size_t k = 0; k < shown.points().size(); ++k)
    if (const shaft::ShaftPrediction& p = shown.predictions()[k]; p.equilibrium.report.converged())
      curve.push_back({.speed = shown.points()[k].speed, .displacement = p.displacement});
  try {
    const shaft::KinematicLawFit f = shaft::fit_kinematic_law(curve);
    if (f.converged()) return {f, law_statement(f, "raceway fit-law -o FILE writes this table")};
    return {std::nullopt, fmt::format("The fit of the law did not converge: {} after {} steps.",
                                      fit::name(f.status), f.iterations)};
  } catch (const std::invalid_argument& e) {
    return {std::nullopt, fmt::format("No law was fitted: {}.", e.what())};
  }
}

std::vector<shaft::ShaftPoint> points_of(Messages& messages, const files::ModelFile& file,
                                         const CurveQuestion& question) {
  require_shaft(file);
  const std::vector<double>& speeds = question.speed_rpm;
  const std::string name = named(question.wording, "--speed", "speed_rpm");
  if (speeds.size() > 1000000)
    throw text::InputError(
        fmt::format("{}: {} speeds are given; at most 1e6 are allowed", name, speeds.size()),
        {.key = name});
  const bearing::OperatingPoint point = operating_point(
      messages, file,
      {.axial_load_N = question.axial_load_N, .temperature_C = question.temperature_C},
      question.wording);
  std::vector<shaft::ShaftPoint> points;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    text::require_range(speeds[i], text::speed_range,
                        question.wording == Wording::flags ? name : fmt::format("{}[{}]", name, i));
    points.push_back({.speed = speeds[i] * rpm,
                      .external_load = point.axial_load,
                      .temperature = point.temperature});
    require_possible_speed(file.model, points.back().speed, name);
  }
  return points;
}

}  // namespace

ShaftCurve::ShaftCurve(Messages& messages, const files::ModelFile& file,
                       const CurveQuestion& question)
    : file_(&file),
      points_(points_of(messages, file, question)),
      predictions_(shaft::predict_shaft(file.model, points_)),
      findings_(judge(file.model, points_, predictions_)) {
  if (question.band) band_ = shaft_band(*question.band, points_);
}

bool ShaftCurve::converged() const {
  return std::none_of(predictions_.begin(), predictions_.end(), has_failed);
}

std::vector<record::Note> ShaftCurve::warnings() const {
  std::vector<record::Note> notes =
      notes_of(record::note::unloaded, shaft_warnings(file_->model, points_, predictions_));
  append(notes, said_of(findings_));
  const auto first = std::find_if(predictions_.begin(), predictions_.end(), has_failed);
  if (first != predictions_.end())
    notes.push_back(record::note::no_prediction(fmt::format(
        "{} of {} speeds have {}; the first is {:.6g} rpm: {}",
        std::count_if(predictions_.begin(), predictions_.end(), has_failed), points_.size(),
        first->equilibrium.report.converged() ? "a position, but no torque" : "no value",
        points_[static_cast<std::size_t>(first - predictions_.begin())].speed / rpm,
        shaft_problem(file_->model, *first))));
  return notes;
}

std::string ShaftCurve::json() const {
  return results::displacement_json(file_->model, points_, predictions_, band(), findings_);
}

std::string ShaftCurve::csv() const {
  return results::displacement_text(file_->model, points_, predictions_, file_->text, band());
}

std::string ShaftCurve::page() const {
  return report::displacement_report(file_->source, file_->model, points_, predictions_,
                                     law_of(*this), texts(warnings()),
                                     {of_page(*file_, file_->model)}, findings_);
}

}  // namespace raceway::session
