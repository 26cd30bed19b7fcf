#include "cli/state_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bearing/contact_pressure.h"
#include "bearing/frequencies.h"
#include "bearing/shoulder.h"
#include "cli/band_flag.h"
#include "cli/text_table.h"
#include "model/bearing_life.h"
#include "session/bands.h"
#include "session/contact_statement.h"

namespace raceway::cli {
namespace {

void print_balls(const bearing::BearingEquilibrium& e) {
  const bool alike = std::all_of(
      e.balls.begin(), e.balls.end(),
      [&](const bearing::BallEquilibrium& b) { return b.inner_load == e.balls[0].inner_load; });
  TextTable table({alike ? TextTable::Column{"balls", ""} : TextTable::Column{"ball at", "deg"},
                   {"inner angle", "deg"},
                   {"outer angle", "deg"},
                   {"inner load", "N"},
                   {"outer load", "N"},
                   {"centrifug.", "N"},
                   {"gyrosc.", "N mm"}});
  for (std::size_t k = 0; k < (alike ? 1 : e.balls.size()); ++k) {
    const bearing::BallEquilibrium& b = e.balls[k];
    table.add(
        {alike ? fmt::format("all {}", e.balls.size()) : fmt::format("{:.1f}", b.azimuth / degree),
         number(b.inner_contact_angle / degree), number(b.outer_contact_angle / degree),
         number(b.inner_load), number(b.outer_load), number(b.centrifugal_force),
         number(b.gyroscopic_moment / N_mm)});
  }
  fmt::print("{}", table.text(terminal_width()));
}

/// β of the balls that touch both races, or its range [deg].
std::string pitch_angles(const bearing::Bearing& bearing, const bearing::BearingEquilibrium& e,
                         const bearing::EquilibriumOptions& solver) {
  double least = unset, largest = unset;
  for (std::size_t k = 0; k < e.balls.distinct().size(); ++k) {
    if (!(e.balls.distinct()[k].inner_load > 0.0)) continue;
    const double pitch = e.speeds(k, bearing, 1.0, solver.race_control).pitch_angle / degree;
    least = std::fmin(least, pitch);
    largest = std::fmax(largest, pitch);
  }
  const std::string from = number(least), to = number(largest);
  return from == to ? from : from + " to " + to;
}

/// What the shoulders leave, where they are given.
void print_shoulders(const bearing::Bearing& bearing, const bearing::BearingEquilibrium& e) {
  const bearing::PermissibleLoads load = permissible_axial_loads(bearing);
  if (std::isnan(load.least())) return;
  const bearing::ShoulderMargins left = shoulder_margins(bearing, e);
  const auto angle = [](double margin) {
    return std::isnan(margin) ? std::string("unknown") : fmt::format("{:.2f} deg", margin / degree);
  };
  fmt::print("margin of the contact ellipse: {} to the inner shoulder, {} to the outer shoulder\n",
             angle(left.inner), angle(left.outer));
  if (std::isinf(load.least()))
    fmt::print("permissible axial load at standstill: not limited by the shoulders\n");
  else
    fmt::print("permissible axial load at standstill {} N, limited by the {} shoulder\n",
               number(load.least()), load.inner == load.least() ? "inner" : "outer");
}

}  // namespace

void print_torque(const model::Model& model, const model::FrictionPrediction& friction,
                  const friction::HeatSplit& heat) {
  fmt::print("\nfriction torque     {:>10} N mm    power loss        {:>8} W\n",
             number(friction.torque / N_mm), number(friction.power_loss));
  const std::vector<std::string> names = torque_parts(model);
  const std::vector<double> moments = moments_of_parts(model, friction);
  for (std::size_t i = 0; i < std::max<std::size_t>(2, names.size()); ++i) {
    if (i < names.size())
      fmt::print("  {:<17} {:>10} N mm", names[i], number(moments[i] / N_mm));
    else
      fmt::print("{:<35}", "");
    if (i < 2)
      fmt::print("      {} ring      {:>8} W", i == 0 ? "inner" : "outer",
                 number(i == 0 ? heat.inner : heat.outer));
    fmt::print("\n");
  }
}

void print_life(const model::BearingLife& life, const bearing::BearingFrequencies& turns,
                double speed, std::string_view element) {
  constexpr double hour = 3600.0;
  fmt::print("\nbasic life L10      {:>10} h       reference L10r    {:>8} h\n",
             number(life.basic / hour), number(life.reference / hour));
  fmt::print("{:<19} {:>10} {:<10}a_ISO             {:>8}\n",
             element == "roller" ? "modified a_ISO L10r" : "modified a_ISO L10",
             life.hybrid ? "none" : number(life.modified / hour), life.hybrid ? "" : "h",
             number(life.modification));
  fmt::print("kappa               {:>10}         static safety     {:>8}\n",
             number(life.viscosity_ratio), number(life.static_safety));
  fmt::print("cage speed          {:>10} rpm     {:<17} {:>8} Hz\n",
             number(turns.cage * speed / rpm), fmt::format("{} pass outer", element),
             number(turns.outer_race * speed / (2.0 * pi)));
}

void print_state(const model::Model& model, const bearing::OperatingPoint& p,
                 const session::PointAnswer& answer) {
  const bearing::BearingEquilibrium& e = answer.equilibrium;
  const model::FrictionPrediction& friction = answer.friction;
  fmt::print("{} at {:.6g} rpm, axial load {:.6g} N, radial load {:.6g} N, {:.4g} C\n", model.name,
             p.speed / rpm, p.axial_load, p.radial_load, celsius(p.temperature));
  fmt::print("{} in {} Newton steps; relative error of the load balance {:.0e}\n\n",
             bearing::name(e.report.status), e.report.iterations, e.report.recovered_load_error);
  print_balls(e);
  if (e.lost_balls() > 0)
    fmt::print("{} of {} balls have no contact with the inner race\n", e.lost_balls(),
               e.balls.size());
  if (model.balanced_balls)
    fmt::print(
        "rotation axes of the balls, from the traction in the contacts: {} deg to the bearing "
        "axis\n",
        pitch_angles(bearing_of(model, friction), e, model.solver));
  const auto& u = e.displacement;
  fmt::print("\naxial displacement  {:>10} um      axial stiffness   {:>8} N/um\n",
             number(u[0] / um), number(e.stiffness(0, 0) / N_per_um));
  fmt::print("displacement in y   {:>10} um      radial stiffness  {:>8} N/um\n", number(u[1] / um),
             number(e.stiffness(1, 1) / N_per_um));
  fmt::print("displacement in z   {:>10} um\n", number(u[2] / um));
  const bearing::ContactPressure pressure = largest_pressure(bearing_of(model, friction), e);
  fmt::print("inner pressure      {:>10} MPa     outer pressure    {:>8} MPa\n",
             number(pressure.inner / MPa), number(pressure.outer / MPa));
  print_shoulders(bearing_of(model, friction), e);
  if (model.solver.tilt == bearing::Tilt::free)
    fmt::print("tilt y, z           {:>10}, {} mrad\n", number(u[3] / mrad), number(u[4] / mrad));
  print_torque(model, friction, answer.heat);
  if (friction.contacts) fmt::print("{}\n", session::judgement(*friction.contacts));
  print_life(bearing_life(model, p, friction),
             running_frequencies(bearing_of(model, friction), *friction.equilibrium,
                                 model.solver.race_control),
             p.speed, "ball");
}

void print_band(const model::Band& band, const session::PointAnswer& answer) {
  const std::vector<double>& half_widths = answer.band->half_widths;
  fmt::print("\n{}\n", session::band_statement(band));
  if (answer.shaft)
    return fmt::print("axial displacement {} um, friction torque {} N mm, power loss {} W\n",
                      band_text(half_widths[0], um), band_text(half_widths[1], N_mm),
                      band_text(half_widths[2]));
  fmt::print("friction torque     {:>10} N mm    power loss        {:>8} W\n",
             band_text(half_widths[0], N_mm), band_text(half_widths[1]));
  fmt::print("inner ring          {:>10} W       outer ring        {:>8} W\n",
             band_text(half_widths[2]), band_text(half_widths[3]));
}

}  // namespace raceway::cli
