#include "cli/roller_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bearing/roller_equilibrium.h"
#include "cli/state_text.h"
#include "cli/text_table.h"

namespace raceway::cli {
namespace {

/// In mrad; zero where only rounding is left of it.
std::string tilt_text(double tilt) {
  constexpr double rounding = 1e-12;
  return number(std::abs(tilt) < rounding ? 0.0 : tilt / mrad);
}

void print_rollers(const bearing::RollerEquilibrium& e) {
  const bool alike = std::all_of(e.rollers.begin(), e.rollers.end(), [&](const auto& r) {
    return r.inner_load == e.rollers[0].inner_load;
  });
  TextTable table({alike ? TextTable::Column{"rollers", ""} : TextTable::Column{"roller at", "deg"},
                   {"inner load", "N"},
                   {"outer load", "N"},
                   {"tilt", "mrad"}});
  for (std::size_t k = 0; k < (alike ? 1 : e.rollers.size()); ++k) {
    const bearing::LoadedRoller& r = e.rollers[k];
    table.add({alike ? fmt::format("all {}", e.rollers.size())
                     : fmt::format("{:.1f}", r.azimuth / degree),
               number(r.inner_load), number(r.outer_load), tilt_text(r.tilt)});
  }
  fmt::print("{}", table.text(terminal_width()));
}

}  // namespace

void print_roller_state(const model::Model& model, const bearing::OperatingPoint& p,
                        const session::PointAnswer& answer) {
  const model::FrictionPrediction& friction = answer.friction;
  const bearing::RollerEquilibrium& e = *friction.rollers;
  fmt::print("{} at {:.6g} rpm, radial load {:.6g} N, clearance {:.4g} um, {:.4g} C\n", model.name,
             p.speed / rpm, p.radial_load, e.clearance / um, celsius(p.temperature));
  fmt::print("{} in {} Newton steps\n\n", e.status(), e.report.iterations);
  print_rollers(e);
  fmt::print("{} of {} rollers touch the inner ring\n", e.loaded_rollers(), e.rollers.size());
  const auto& u = e.displacement;
  fmt::print("\ndisplacement in y   {:>10} um      stiffness in y    {:>8} N/um\n",
             number(u[0] / um), number(e.stiffness(0, 0) / N_per_um));
  fmt::print("displacement in z   {:>10} um      stiffness in z    {:>8} N/um\n", number(u[1] / um),
             number(e.stiffness(1, 1) / N_per_um));
  const bearing::ContactPressure pressure = largest_pressure(*model.bearing.rollers(), e);
  fmt::print("inner pressure      {:>10} MPa     outer pressure    {:>8} MPa\n",
             number(pressure.inner / MPa), number(pressure.outer / MPa));
  if (model.solver.tilt == bearing::Tilt::free)
    fmt::print("tilt y, z           {:>10}, {} mrad\n", tilt_text(u[2]), tilt_text(u[3]));
  print_torque(model, friction, answer.heat);
  print_life(bearing_life(model, p, friction),
             bearing::rolling_frequencies(model.bearing.rollers()->geometry()), p.speed, "roller");
}

}  // namespace raceway::cli
