#include "session/solve_point.h"

#include <fmt/format.h>

#include <cmath>

#include "bearing/contact_pressure.h"
#include "bearing/shoulder.h"
#include "model/heat_split.h"
#include "results/results.h"
#include "results/roller_results.h"
#include "results/shaft_results.h"
#include "session/bands.h"
#include "session/contact_statement.h"
#include "session/judged.h"
#include "session/operating_point.h"
#include "session/roller_notes.h"
#include "session/shaft_answers.h"

namespace raceway::session {

namespace {

/// Either there is certainly no equilibrium, or the solver did not find one.
std::string words_of_absence(const bearing::SolveReport& report,
                             const bearing::OperatingPoint& point) {
  if (!report.certain) return ": the solver found no inner ring position that carries this load";
  return point.axial_load < 0.0 ? ": the axial load pulls the ring away from its only shoulder"
                                : ": no load presses the ring against the balls";
}

std::string words_of_failure(const bearing::SolveReport& report,
                             const bearing::OperatingPoint& point) {
  switch (report.status) {
    case bearing::SolveStatus::no_equilibrium:
      return words_of_absence(report, point);
    case bearing::SolveStatus::singular:
      return ": the balls that carry this load are too few to support the ring against tilt";
    case bearing::SolveStatus::not_finite:
      return "";
    default:
      return fmt::format(" after {} Newton steps", report.iterations);
  }
}

PointAnswer solve_shaft(const model::Model& model, const bearing::OperatingPoint& point,
                        const std::optional<model::Band>& band) {
  const std::vector<shaft::ShaftPoint> asked = shaft_points({&point, 1});
  const std::vector<shaft::ShaftPrediction> found = shaft::predict_shaft(model, asked);
  PointAnswer answer{.status = found[0].status(), .shaft = found[0]};
  answer.findings = judge(model, asked, found);
  if (band) answer.band = shaft_band(*band, asked);
  answer.why = fmt::format("{:.6g} rpm, {:.6g} N external load: {}", point.speed / rpm,
                           point.axial_load, shaft_problem(model, found[0]));
  return answer;
}

model::Findings judge(const model::Model& model, const bearing::OperatingPoint& point,
                      const PointAnswer& answer) {
  model::Judge judge(model);
  if (model.bearing.rollers()) {
    judge.look_at_speed(model.bearing.pitch_diameter(), false, "", point);
    return judge.findings();
  }
  const bearing::Bearing& bearing = bearing_of(model, answer.friction);
  const bearing::ContactPressure pressure = largest_pressure(bearing, answer.equilibrium);
  double least = unset, largest = unset;
  for (const bearing::BallEquilibrium& b : answer.equilibrium.balls.distinct()) {
    least = std::fmin(least, b.inner_contact_angle);
    largest = std::fmax(largest, b.inner_contact_angle);
  }
  // Lost balls stand in the result.
  judge.look(bearing, "", point,
             {.axial_load = point.axial_load,
              .radial_load = std::hypot(point.radial_load, point.radial_load_z),
              .inner_pressure = pressure.inner,
              .outer_pressure = pressure.outer,
              .least_inner_angle = least,
              .largest_inner_angle = largest});
  return judge.findings();
}

}  // namespace

PointAnswer solve_point(const model::Model& model, const bearing::OperatingPoint& point,
                        const std::optional<model::Band>& band) {
  if (model.shaft) return solve_shaft(model, point, band);
  PointAnswer answer;
  answer.friction = model::predict_friction(model, point, true);
  answer.status = answer.friction.status();
  if (band) answer.band = point_band(*band, point);
  if (answer.converged()) {
    if (answer.friction.equilibrium) answer.equilibrium = *answer.friction.equilibrium;
    answer.heat = model::heat_split(model, point, answer.friction);
    answer.findings = judge(model, point, answer);
    return answer;
  }
  bearing::SolveReport& report = answer.equilibrium.report = answer.friction.report;
  report.status = answer.status;
  answer.why = fmt::format("{} at {:.6g} rpm, {:.6g} N axial, {:.6g} N radial{}",
                           why_not_converged(model, answer.friction), point.speed / rpm,
                           point.axial_load, point.radial_load, words_of_failure(report, point));
  const std::size_t effects = answer.friction.effects.size();
  answer.friction = {};
  answer.friction.report = report;
  answer.friction.effects.assign(effects, unset);
  return answer;
}

std::string point_json(const model::Model& model, const bearing::OperatingPoint& point,
                       const PointAnswer& answer) {
  const results::BandOfResult* const band = answer.band ? &*answer.band : nullptr;
  if (answer.shaft)
    return results::shaft_solve_json(model, shaft_points({&point, 1}).front(), *answer.shaft, band,
                                     answer.findings);
  if (model.bearing.rollers())
    return results::roller_solve_json(model, point, answer.friction, answer.heat, band,
                                      answer.findings);
  return results::solve_json(model, point, answer.equilibrium, answer.friction, answer.heat, band,
                             answer.findings);
}

std::vector<record::Note> notes_on_point(const model::Model& model,
                                         const bearing::OperatingPoint& point,
                                         const PointAnswer& answer) {
  if (answer.shaft) {
    std::vector<record::Note> notes =
        notes_of(record::note::unloaded,
                 shaft_warnings(model, shaft_points({&point, 1}), {&*answer.shaft, 1}));
    append(notes, said_of(answer.findings));
    return notes;
  }
  if (!answer.converged()) return {};
  std::vector<std::string> lines = model::notes_of(answer.findings);
  for (std::string& line :
       model.bearing.rollers()
           ? notes_on_rollers(model, point, answer.friction)
           : notes_on_state(model, bearing_of(model, answer.friction), point, answer.friction))
    lines.push_back(std::move(line));
  std::vector<record::Note> notes = notes_of(record::note::load_limit, std::move(lines));
  append(notes, warnings_said(answer.findings));
  if (model.bearing.rollers()) return notes;
  const bearing::ShoulderMargins left =
      shoulder_margins(bearing_of(model, answer.friction), answer.equilibrium);
  const auto look = [&](const char* race, double margin, double cut) {
    if (margin < 0.0)
      notes.push_back(record::note::cut_contact(fmt::format(
          "the contact ellipse reaches over the {} shoulder by {:.2g} deg, {:.2g} % of its length: "
          "at the edge, the pressure is higher than the contact pressure in this result",
          race, -margin / degree, 100.0 * cut)));
  };
  look("inner", left.inner, left.inner_cut);
  look("outer", left.outer, left.outer_cut);
  return notes;
}

}  // namespace raceway::session
