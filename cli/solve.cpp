#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/shaft.h"
#include "cli/state_text.h"
#include "io/error.h"
#include "io/results.h"
#include "session/bands.h"
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
    print(file.model, point, answer);
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
