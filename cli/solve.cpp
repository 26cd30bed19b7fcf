#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/contact_pressure.h"
#include "bearing/frequencies.h"
#include "bearing/shoulder.h"
#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/shaft.h"
#include "cli/text_table.h"
#include "io/error.h"
#include "io/results.h"
#include "model/bearing_life.h"
#include "session/bands.h"
#include "session/contact_statement.h"
#include "session/open_input.h"
#include "session/solve_point.h"

namespace raceway::cli {
namespace {

struct SolveFlags {
  std::string model;
  double speed = unset, axial_load = unset, radial_load = unset, temperature = unset;
  double moment_y = 0.0, moment_z = 0.0;
  bool json = false;
  BandFlag band;
};

shaft::ShaftPoint shaft_point(const SolveFlags& f, const model::Model& model) {
  if (f.radial_load > 0.0 || f.moment_y != 0.0 || f.moment_z != 0.0)
    throw io::InputError(
        "raceway solve: " + f.model + " has an [arrangement]: a shaft takes --axial-load alone",
        {.file = f.model});
  return {.speed = f.speed * rpm,
          .external_load = std::isnan(f.axial_load) ? model.shaft->external_load : f.axial_load,
          .temperature = std::isnan(f.temperature) ? model.rig.temperature : kelvin(f.temperature)};
}

bearing::OperatingPoint operating_point(const SolveFlags& f, const model::Rig& rig) {
  if (!std::isnan(f.axial_load)) require_range(f.axial_load, load_range, "--axial-load");
  bearing::OperatingPoint p;
  p.speed = f.speed * rpm;
  p.axial_load = std::isnan(f.axial_load) ? rig.axial_load : f.axial_load;
  p.radial_load = std::isnan(f.radial_load) ? rig.radial_load : f.radial_load;
  p.temperature = std::isnan(f.temperature) ? rig.temperature : kelvin(f.temperature);
  p.moment_y = f.moment_y * N_mm;
  p.moment_z = f.moment_z * N_mm;
  if (std::isnan(p.axial_load))
    throw io::InputError("raceway solve: --axial-load is missing, and " + f.model +
                             " has no axial_load_N under [rig]",
                         {.file = f.model, .key = "--axial-load"});
  return p;
}

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

/// Parts of the torque; beside the first two the heat of the rings.
void print_friction(const model::Model& model, const model::FrictionPrediction& friction,
                    const friction::HeatSplit& heat) {
  fmt::print("\nfriction torque     {:>10} N mm    power loss        {:>8} W\n",
             number(friction.torque / N_mm), number(friction.power_loss));
  const std::vector<std::string> names = torque_parts(model);
  const std::vector<double> moments = moments_of_parts(model, friction);
  for (std::size_t i = 0; i < names.size(); ++i) {
    fmt::print("  {:<17} {:>10} N mm", names[i], number(moments[i] / N_mm));
    if (i < 2)
      fmt::print("      {} ring      {:>8} W", i == 0 ? "inner" : "outer",
                 number(i == 0 ? heat.inner : heat.outer));
    fmt::print("\n");
  }
  if (friction.contacts) fmt::print("{}\n", session::judgement(*friction.contacts));
}

void print_life(const model::Model& model, const bearing::OperatingPoint& point,
                const model::FrictionPrediction& friction) {
  const bearing::Bearing& bearing = friction.bearing ? *friction.bearing : model.bearing;
  const model::BearingLife life = bearing_life(model.life, bearing, point, *friction.equilibrium,
                                               friction.film.kinematic_viscosity);
  const bearing::BearingFrequencies turns =
      running_frequencies(bearing, *friction.equilibrium, model.solver.race_control);
  constexpr double hour = 3600.0;
  fmt::print("\nbasic life L10      {:>10} h       reference L10r    {:>8} h\n",
             number(life.basic / hour), number(life.reference / hour));
  fmt::print("modified life       {:>10} {:<10}a_ISO             {:>8}\n",
             life.hybrid ? "none" : number(life.modified / hour), life.hybrid ? "" : "h",
             number(life.modification));
  fmt::print("kappa               {:>10}         static safety     {:>8}\n",
             number(life.viscosity_ratio), number(life.static_safety));
  fmt::print("cage speed          {:>10} rpm     ball over outer   {:>8} Hz\n",
             number(turns.cage * point.speed / rpm),
             number(turns.outer_race * point.speed / (2.0 * pi)));
}

/// What the shoulders leave, where they are given.
void print_shoulders(const bearing::Bearing& bearing, const bearing::BearingEquilibrium& e) {
  const bearing::PermissibleLoads load = permissible_axial_loads(bearing);
  if (std::isnan(load.least())) return;
  const bearing::ShoulderMargins left = shoulder_margins(bearing, e);
  const auto angle = [](double margin) {
    return std::isnan(margin) ? std::string("none") : fmt::format("{:.2f}", margin / degree);
  };
  fmt::print("to inner shoulder   {:>10} deg     to outer shoulder {:>8} deg\n", angle(left.inner),
             angle(left.outer));
  if (std::isinf(load.least()))
    fmt::print(
        "permissible axial load at standstill: no load brings the ellipses to the shoulders\n");
  else
    fmt::print("permissible axial load at standstill {} N, by the {} shoulder\n",
               number(load.least()), load.inner == load.least() ? "inner" : "outer");
}

void print(const model::Model& model, const bearing::OperatingPoint& p,
           const bearing::BearingEquilibrium& e, const model::FrictionPrediction& friction,
           const friction::HeatSplit& heat) {
  fmt::print("{} at {:.6g} rpm, axial load {:.6g} N, radial load {:.6g} N, {:.4g} C\n", model.name,
             p.speed / rpm, p.axial_load, p.radial_load, celsius(p.temperature));
  fmt::print("{} in {} Newton steps, loads recovered to {:.0e}\n\n", bearing::name(e.report.status),
             e.report.iterations, e.report.recovered_load_error);
  print_balls(e);
  if (e.lost_balls() > 0)
    fmt::print("{} of {} balls have lost the inner race\n", e.lost_balls(), e.balls.size());
  if (model.balanced_balls)
    fmt::print("traction turns the balls about axes at {} deg to the bearing's\n",
               pitch_angles(friction.bearing ? *friction.bearing : model.bearing, e, model.solver));
  const auto& u = e.displacement;
  fmt::print("\naxial displacement  {:>10} um      axial stiffness   {:>8} N/um\n",
             number(u[0] / um), number(e.stiffness(0, 0) / N_per_um));
  fmt::print("displacement in y   {:>10} um      radial stiffness  {:>8} N/um\n", number(u[1] / um),
             number(e.stiffness(1, 1) / N_per_um));
  fmt::print("displacement in z   {:>10} um\n", number(u[2] / um));
  const bearing::ContactPressure pressure =
      largest_pressure(friction.bearing ? *friction.bearing : model.bearing, e);
  fmt::print("inner pressure      {:>10} MPa     outer pressure    {:>8} MPa\n",
             number(pressure.inner / MPa), number(pressure.outer / MPa));
  print_shoulders(friction.bearing ? *friction.bearing : model.bearing, e);
  if (model.solver.tilt == bearing::Tilt::free)
    fmt::print("tilt y, z           {:>10}, {} mrad\n", number(u[3] / mrad), number(u[4] / mrad));
  print_friction(model, friction, heat);
  print_life(model, p, friction);
}

void print_band(const model::Band& band, const std::vector<double>& half_widths) {
  fmt::print("\n{}\n", session::band_statement(band));
  fmt::print("friction torque     {:>10} N mm    power loss        {:>8} W\n",
             band_text(half_widths[0], N_mm), band_text(half_widths[1]));
  fmt::print("inner ring          {:>10} W       outer ring        {:>8} W\n",
             band_text(half_widths[2]), band_text(half_widths[3]));
}

int run(const SolveFlags& flags) {
  const io::ModelFile file =
      session::open_model(messages(), flags.model, session::Accepts::rig_or_shaft);
  session::warn_of_ignored_data(messages(), file);
  session::tell_of_kelvin(messages(), {flags.temperature});
  const std::optional<model::Band> band = flags.band.of(file);
  if (file.model.shaft)
    return solve_shaft(flags.model, file.model, shaft_point(flags, file.model), flags.json,
                       band ? &*band : nullptr);
  const bearing::OperatingPoint point = operating_point(flags, file.model.rig);
  if ((point.moment_y != 0.0 || point.moment_z != 0.0) &&
      file.model.solver.tilt == bearing::Tilt::locked)
    warn(flags.model +
         ": --moment-y and --moment-z change nothing where the shaft holds the tilt; [solver] tilt "
         "= "
         "\"free\" lets the balls carry them");
  const session::PointAnswer answer = session::solve_point(file.model, point);
  const bearing::BearingEquilibrium& e = answer.equilibrium;
  std::optional<io::BandOfResult> half_widths;
  if (band) half_widths = session::point_band(*band, point);
  if (flags.json) {
    put_document(io::solve_json(file.model, point, e, answer.friction, answer.heat,
                                half_widths ? &*half_widths : nullptr));
  } else if (answer.converged()) {
    print(file.model, point, e, answer.friction, answer.heat);
    if (band) print_band(*band, half_widths->half_widths);
  }
  if (answer.converged()) {
    tell(session::notes_on_point(file.model, point, answer));
    for (const std::string& line : session::warnings_on_point(file.model, answer))
      warn("raceway solve: " + line);
    return done;
  }
  const bearing::SolveReport& report = e.report;
  complain(fmt::format("raceway solve: {}: {} at {:.6g} rpm, {:.6g} N axial, {:.6g} N radial{}",
                       flags.model, answer.why, flags.speed, point.axial_load, point.radial_load,
                       report.status == bearing::SolveStatus::no_equilibrium
                           ? ": no position of the inner ring carries this load"
                       : report.status == bearing::SolveStatus::singular
                           ? ": too few balls carry this load to hold the ring's tilt"
                       : report.status != bearing::SolveStatus::not_finite
                           ? fmt::format(" after {} Newton steps", report.iterations)
                           : ""));
  return not_converged;
}

}  // namespace

Run setup_solve(CLI::App& command) {
  auto flags = std::make_shared<SolveFlags>();
  command.add_option("MODEL", flags->model, "model file (TOML)")->required()->type_name("");
  add_number(command, "--speed", flags->speed, speed_range, "of the shaft [rpm]")->required();
  add_number(command, "--axial-load", flags->axial_load, signed_load_range,
             "[N], on a shaft positive towards the tool; default: of the model");
  add_number(command, "--radial-load", flags->radial_load, load_range,
             "along +y [N]; default: [rig] of the model, else 0");
  add_number(command, "--temperature", flags->temperature, temperature_range,
             "of the lubricant [C]; default: [rig] of the model, else 40");
  add_number(command, "--moment-y", flags->moment_y, moment_range,
             "about y [N mm], carried where tilt is free; default 0");
  add_number(command, "--moment-z", flags->moment_z, moment_range,
             "about z [N mm], carried where tilt is free; default 0");
  flags->band.declare(command);
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  command.footer(
      "Example:\n  raceway solve my.toml --speed 10000 --axial-load 600\n"
      "  raceway solve my.toml --speed 10000 --axial-load 600 --radial-load 100 --json");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
