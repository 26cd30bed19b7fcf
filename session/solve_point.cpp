#include "session/solve_point.h"

#include <fmt/format.h>

#include <cmath>

#include "bearing/contact_pressure.h"
#include "bearing/shoulder.h"
#include "model/heat_split.h"
#include "results/results.h"
#include "results/roller_results.h"
#include "session/contact_statement.h"
#include "session/judged.h"
#include "session/roller_notes.h"

namespace raceway::session {

std::string words_of_absence(const bearing::SolveReport& report,
                             const bearing::OperatingPoint& point) {
  if (!report.certain) return ": the solver found no inner ring position that carries this load";
  return point.axial_load < 0.0 ? ": the axial load pulls the ring away from its only shoulder"
                                : ": no load presses the ring against the balls";
}

PointAnswer solve_point(const model::Model& model, const bearing::OperatingPoint& point) {
  PointAnswer answer;
  answer.friction = model::predict_friction(model, point, true);
  answer.status = answer.friction.status();
  answer.why = why_not_converged(model, answer.friction);
  if (answer.converged()) {
    if (answer.friction.equilibrium) answer.equilibrium = *answer.friction.equilibrium;
    answer.heat = model::heat_split(model, point, answer.friction);
    return answer;
  }
  answer.equilibrium.report = answer.friction.report;
  answer.equilibrium.report.status = answer.status;
  const std::size_t effects = answer.friction.effects.size();
  answer.friction = {};
  answer.friction.report = answer.equilibrium.report;
  answer.friction.effects.assign(effects, unset);
  return answer;
}

std::string point_json(const model::Model& model, const bearing::OperatingPoint& point,
                       const PointAnswer& answer, const results::BandOfResult* band) {
  const model::Findings findings = judge(model, point, answer);
  if (model.bearing.rollers())
    return results::roller_solve_json(model, point, answer.friction, answer.heat, band, findings);
  return results::solve_json(model, point, answer.equilibrium, answer.friction, answer.heat, band,
                             findings);
}

model::Findings judge(const model::Model& model, const bearing::OperatingPoint& point,
                      const PointAnswer& answer) {
  if (!answer.converged()) return {};
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

std::vector<record::Note> notes_on_point(const model::Model& model,
                                         const bearing::OperatingPoint& point,
                                         const PointAnswer& answer) {
  std::vector<std::string> lines = model::notes_of(judge(model, point, answer));
  for (std::string& line :
       model.bearing.rollers()
           ? notes_on_rollers(model, point, answer.friction)
           : notes_on_state(model, bearing_of(model, answer.friction), point, answer.friction))
    lines.push_back(std::move(line));
  return notes_of(record::note::load_limit, std::move(lines));
}

std::vector<record::Note> warnings_on_point(const model::Model& model,
                                            const bearing::OperatingPoint& point,
                                            const PointAnswer& answer) {
  std::vector<record::Note> notes = warnings_said(judge(model, point, answer));
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
