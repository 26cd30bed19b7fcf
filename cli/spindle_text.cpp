#include "cli/spindle_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/spindle_state_text.h"
#include "cli/text_table.h"
#include "record/units.h"

namespace raceway::cli {
namespace {

/// The assumed numbers that matter most, a line each.
void print_assumptions(const results::Assumptions& assumptions) {
  if (!assumptions.known()) return;
  TextTable table(
      {{"assumed", "", true}, {"value", ""}, {"+-", ""}, {"less", "um"}, {"more", "um"}});
  for (const results::Assumption& a : assumptions.most) {
    const auto moved = [&](double to, bool allowed) {
      return std::isfinite(to) ? fmt::format("{:+.3g}", (to - assumptions.displacement) / um)
                               : std::string(allowed ? "no state" : "-");
    };
    table.add({a.name, fmt::format("{:.6g}", a.value), fmt::format("{:.3g}", a.spread),
               moved(a.low, a.low_allowed), moved(a.high, a.high_allowed)});
  }
  fmt::print(
      "\nlargest influences of {} assumed numbers on the nose displacement (steady state at {:.6g} "
      "rpm): change of the displacement if the number is smaller or larger by its usual "
      "spread\n\n{}",
      assumptions.assumed, assumptions.speed / rpm, table.text(terminal_width()));
}

void print_list(const model::Model& model, const std::vector<results::SteadyState>& states) {
  TextTable table({{"speed", "rpm"},
                   {"friction", "W"},
                   {"displacement", "um"},
                   {"front", "N"},
                   {"rear", "N"},
                   {"stiffness", "N/um"},
                   {"hottest ring", "C"},
                   {"status", "", true}});
  for (const results::SteadyState& s : states) {
    double hottest = unset;
    for (const spindle::BearingState& b : s.moment.bearings)
      hottest = std::fmax(hottest, std::fmax(b.inner_ring_temperature, b.outer_ring_temperature));
    const bool found = s.report.converged();
    table.add({fmt::format("{:.6g}", s.inputs.speed / rpm),
               number(found ? s.moment.heat.friction : unset), number(s.moment.displacement / um),
               number(s.moment.front_force), number(s.moment.rear_force),
               number(s.axial_stiffness / N_per_um), number(celsius(hottest)),
               std::string(spindle::name(s.report.status))});
  }
  fmt::print("Steady states of {}\n\n{}", model.spindle->name, table.text(terminal_width()));
}

}  // namespace

void print_steady(const session::SteadySpindle& found) {
  const model::Model& model = found.file.model;
  const std::vector<results::SteadyState>& states = found.states;
  if (states.size() == 1)
    print_steady_state(model, states.front());
  else
    print_list(model, states);
  fmt::print("{}{}\n", states.size() == 1 ? "" : "\n", session::words(found.mesh));
  print_assumptions(found.assumptions);
}

void print_run(const session::SpindleRun& found) {
  const model::Model& model = found.file.model;
  const spindle::Run& run = found.run;
  fmt::print("{}: {} of {} rows, {} steps, {} rejected\n", model.spindle->name,
             found.rows_reached(), found.rows_asked(), run.report.steps + run.report.rejected,
             run.report.rejected);
  if (!found.converged())
    fmt::print("the simulation ended early after {:.6g} s: {}\n", run.end.time, run.report.message);
  if (run.moments.empty()) return;
  const spindle::Moment& m = run.moments.back();
  if (!model.spindle->network) {
    const auto by_displacement = [](const spindle::Moment& a, const spindle::Moment& b) {
      return a.displacement < b.displacement;
    };
    const auto [least, most] =
        std::minmax_element(run.moments.begin(), run.moments.end(), by_displacement);
    fmt::print(
        "displacement of the nose relative to the flange: {} um at the end, smallest {} um at "
        "{:.6g} s, largest {} um at {:.6g} s\n",
        number(m.displacement / um), number(least->displacement / um), least->time,
        number(most->displacement / um), most->time);
    fmt::print("front force: {} N at the end, largest value {} N at {:.6g} s\n",
               number(m.front_force), number(run.highest_front_force), run.time_of_highest_force);
  }
  fmt::print("friction {} W at the end; relative error of the energy balance {:.1g}\n",
             friction_words(m.heat.friction, m.heat.friction_band), run.report.energy_error);
  fmt::print("{}\n", session::words(found.mesh));
  print_assumptions(found.assumptions);
}

}  // namespace raceway::cli
