#include "cli/shaft.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/commands.h"
#include "cli/open_input.h"
#include "cli/text_table.h"
#include "io/shaft_results.h"

namespace raceway::cli {
namespace {

using Happens = bool (*)(const bearing::BearingInSet&);

/// Where it begins or ends to happen to bearing i, to half an rpm: between `early`, where it does
/// not yet, and `late`, where it does.
fit::ShaftPoint change_between(const fit::Model& model, std::size_t i, Happens happens,
                               const fit::ShaftPoint& early, fit::ShaftPoint late, bool begins) {
  double lower = early.speed;
  while (late.speed - lower > 0.5 * rpm) {
    fit::ShaftPoint middle = late;
    middle.speed = 0.5 * (lower + late.speed);
    const auto p = fit::predict_shaft(model, {&middle, 1});
    const bool here = p[0].equilibrium.report.converged() && happens(p[0].equilibrium.bearings[i]);
    if (here == begins)
      late = middle;
    else
      lower = middle.speed;
  }
  return late;
}

/// A range of speeds in which something happens to the bearings at `places`, "front_1, front_2".
struct Event {
  std::string places;
  fit::ShaftPoint first;
  double end;  ///< speed at which it is over, NaN where it lasts to the last point [rad/s]
  double load, minimum;

  [[nodiscard]] std::string speeds() const {
    return std::isnan(end) ? fmt::format("from {:.0f} rpm on", first.speed / rpm)
                           : fmt::format("from {:.0f} to {:.0f} rpm", first.speed / rpm, end / rpm);
  }
};

/// `points` rise in speed.
std::vector<Event> events(const fit::Model& model, Happens happens,
                          std::span<const fit::ShaftPoint> points,
                          std::span<const fit::ShaftPrediction> predictions) {
  std::vector<Event> found;
  const bearing::Arrangement& a = model.shaft->arrangement;
  const auto balanced = [&](std::size_t k) {
    return predictions[k].equilibrium.report.converged();
  };
  for (std::size_t i = 0; i < a.bearings().size(); ++i) {
    const auto here = [&](std::size_t k) {
      return balanced(k) && happens(predictions[k].equilibrium.bearings[i]);
    };
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!here(k)) continue;
      const fit::ShaftPoint first =
          k > 0 && balanced(k - 1)
              ? change_between(model, i, happens, points[k - 1], points[k], true)
              : points[k];
      while (k + 1 < points.size() && here(k + 1)) ++k;
      double end = unset;
      if (k + 1 < points.size())
        end = balanced(k + 1)
                  ? change_between(model, i, happens, points[k], points[k + 1], false).speed
                  : points[k].speed;
      const std::string place = io::bearing_place(a, i);
      const auto alike = std::find_if(found.begin(), found.end(), [&](const Event& e) {
        return e.first.speed == first.speed &&
               (e.end == end || (std::isnan(e.end) && std::isnan(end)));
      });
      if (alike != found.end()) {
        alike->places += ", " + place;
        continue;
      }
      Event event{place, first, end, unset, unset};
      const auto p = fit::predict_shaft(model, {&first, 1});
      if (p[0].equilibrium.report.converged()) {
        event.load = p[0].equilibrium.bearings[i].axial_load;
        event.minimum = p[0].equilibrium.bearings[i].minimum_load;
      }
      found.push_back(event);
    }
  }
  return found;
}

}  // namespace

std::vector<std::string> shaft_warnings(const fit::Model& model,
                                        std::span<const fit::ShaftPoint> points,
                                        std::span<const fit::ShaftPrediction> predictions) {
  std::vector<std::string> lines;
  for (const Event& e : events(
           model, [](const bearing::BearingInSet& b) { return b.lost(); }, points, predictions))
    lines.push_back(
        fmt::format("{}: no contact with the inner ring {}; no load", e.places, e.speeds()));
  for (const Event& e : events(
           model, [](const bearing::BearingInSet& b) { return !b.lost() && b.below_minimum(); },
           points, predictions))
    lines.push_back(
        fmt::format("{}: below the minimum load {}, there {:.4g} N of {:.4g} N; balls may skid",
                    e.places, e.speeds(), e.load, e.minimum));
  return lines;
}

std::string shaft_problem(bearing::SolveStatus status) {
  switch (status) {
    case bearing::SolveStatus::no_equilibrium:
      return "no_equilibrium: the sets balance at no position of the shaft";
    case bearing::SolveStatus::singular:
      return "singular: both sets are free, nothing holds the shaft";
    case bearing::SolveStatus::not_finite:
      return "not_finite: an effect lacks what it looks at, as ring temperatures";
    default:
      return std::string(bearing::name(status));
  }
}

int solve_shaft(const std::string& file, const fit::Model& model, const fit::ShaftPoint& point,
                bool json) {
  const auto predictions = fit::predict_shaft(model, {&point, 1});
  const fit::ShaftPrediction& p = predictions[0];
  const bearing::ArrangementEquilibrium& e = p.equilibrium;
  if (json) fmt::print("{}", io::shaft_solve_json(model, point, p));
  if (!e.report.converged()) {
    say(fmt::format("raceway solve: {}: {:.6g} rpm, {:.6g} N external load: {}", file,
                    point.speed / rpm, point.external_load, shaft_problem(e.report.status)));
    return not_converged;
  }
  if (!json) {
    const bearing::Arrangement& a = model.shaft->arrangement;
    fmt::print("{} in its arrangement at {:.6g} rpm, external load {:.6g} N, {:.4g} C\n",
               model.name, point.speed / rpm, point.external_load, celsius(point.temperature));
    fmt::print("{} in {} Newton steps, loads recovered to {:.0e}\n\n",
               bearing::name(e.report.status), e.report.iterations, e.report.recovered_load_error);
    TextTable table({{"bearing", "", true},
                     {"axial load", "N"},
                     {"inner angle", "deg"},
                     {"outer angle", "deg"},
                     {"inner load", "N"},
                     {"outer load", "N"},
                     {"inner", "MPa"},
                     {"outer", "MPa"},
                     {"torque", "N mm"},
                     {"heat", "W"}});
    for (std::size_t i = 0; i < e.bearings.size(); ++i) {
      const bearing::BearingInSet& b = e.bearings[i];
      table.add({io::bearing_place(a, i), number(b.axial_load),
                 number(b.ball.inner_contact_angle / degree),
                 number(b.ball.outer_contact_angle / degree), number(b.ball.inner_load),
                 number(b.ball.outer_load), number(b.inner_pressure / MPa),
                 number(b.outer_pressure / MPa), number(p.friction[i].torque / N_mm),
                 number(p.friction[i].power_loss)});
    }
    fmt::print("{}", table.text(terminal_width()));
    const bearing::LiftOff free = lift_off(a);
    fmt::print(
        "\naxial displacement  {:>10} um      against standstill, positive towards the tool\n",
        number(p.displacement / um));
    fmt::print("axial stiffness     {:>10} N/um\n", number(e.axial_stiffness / N_per_um));
    fmt::print("front force         {:>10} N       rear force        {:>8} N\n",
               number(e.front_force), number(e.rear_force));
    fmt::print(
        "front set is free   {:>10} N       rear set is free  {:>8} N external load, at "
        "standstill\n",
        number(free.front), number(free.rear));
    fmt::print("friction torque     {:>10} N mm    power loss        {:>8} W\n",
               number(p.torque / N_mm), number(p.power_loss));
  }
  tell(shaft_warnings(model, {&point, 1}, predictions));
  return done;
}

}  // namespace raceway::cli
