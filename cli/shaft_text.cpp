#include "cli/shaft_text.h"

#include <fmt/core.h>

#include <cmath>

#include "cli/text_table.h"
#include "results/shaft_results.h"
#include "shaft/shaft_balance.h"

namespace raceway::cli {
namespace {

void print_bearings(const bearing::Arrangement& a, const shaft::ShaftPrediction& p) {
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
  for (std::size_t i = 0; i < p.equilibrium.bearings.size(); ++i) {
    const bearing::BearingInSet& b = p.equilibrium.bearings[i];
    table.add({results::bearing_place(a, i), number(b.axial_load),
               number(b.ball.inner_contact_angle / degree),
               number(b.ball.outer_contact_angle / degree), number(b.ball.inner_load),
               number(b.ball.outer_load), number(b.inner_pressure / MPa),
               number(b.outer_pressure / MPa), number(p.friction[i].torque / N_mm),
               number(p.friction[i].power_loss)});
  }
  fmt::print("{}", table.text(terminal_width()));
}

void print_sums(const model::Model& model, const shaft::ShaftPrediction& p) {
  const bearing::ArrangementEquilibrium& e = p.equilibrium;
  const bearing::Arrangement a = shaft::mounted_arrangement(model);
  const bearing::LiftOff free = lift_off(a);
  fmt::print("\naxial displacement  {:>10} um      from standstill, positive towards the tool\n",
             number(p.displacement / um));
  fmt::print("axial position      {:>10} um      from the mounted state without external load\n",
             number(e.position / um));
  fmt::print("axial stiffness     {:>10} N/um\n", number(e.axial_stiffness / N_per_um));
  fmt::print("front force         {:>10} N       rear force        {:>8} N\n",
             number(e.front_force), number(e.rear_force));
  fmt::print(
      "at standstill, the front set loses contact at an external load of {} N, "
      "and the rear set {}\n",
      number(free.front),
      std::isnan(free.rear) ? "at no load" : fmt::format("at {} N", number(free.rear)));
  fmt::print("friction torque     {:>10} N mm    power loss        {:>8} W\n",
             number(p.torque / N_mm), number(p.power_loss));
}

}  // namespace

void print_shaft_state(const model::Model& model, const bearing::OperatingPoint& point,
                       const shaft::ShaftPrediction& p) {
  const bearing::SolveReport& report = p.equilibrium.report;
  fmt::print("{} in its arrangement at {:.6g} rpm, external load {:.6g} N, {:.4g} C\n", model.name,
             point.speed / rpm, point.axial_load, celsius(point.temperature));
  fmt::print("{} in {} Newton steps; relative error of the load balance {:.0e}\n\n",
             bearing::name(report.status), report.iterations, report.recovered_load_error);
  print_bearings(model.shaft->arrangement, p);
  print_sums(model, p);
}

}  // namespace raceway::cli
