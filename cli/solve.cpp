#include <fmt/core.h>

#include <optional>

#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/roller_text.h"
#include "cli/shaft.h"
#include "cli/shared_flags.h"
#include "cli/state_text.h"
#include "session/bands.h"
#include "session/open_input.h"
#include "session/operating_point.h"
#include "session/solve_point.h"

namespace raceway::cli {
namespace {

struct SolveFlags {
  std::string model;
  session::AskedPoint point;
  bool json = false;
  BandFlag band;
};

int run(const SolveFlags& flags) {
  const files::ModelFile file =
      session::open_model(messages(), flags.model, session::Accepts::rig_or_shaft);
  session::warn_of_ignored_data(messages(), file);
  const std::optional<model::Band> band = flags.band.of(file);
  const bearing::OperatingPoint point =
      session::operating_point(messages(), file, flags.point, session::Wording::flags);
  if (file.model.shaft)
    return solve_shaft(flags.model, file.model, session::shaft_points({&point, 1}).front(),
                       flags.json, band ? &*band : nullptr);
  const session::PointAnswer answer = session::solve_point(file.model, point);
  std::optional<results::BandOfResult> half_widths;
  if (band) half_widths = session::point_band(*band, point);
  if (flags.json) {
    put_document(
        session::point_json(file.model, point, answer, half_widths ? &*half_widths : nullptr));
  } else if (answer.converged()) {
    if (file.model.bearing.rollers())
      print_roller_state(file.model, point, answer);
    else
      print_state(file.model, point, answer);
    if (band) print_band(*band, half_widths->half_widths);
  }
  if (answer.converged()) {
    tell(session::notes_on_point(file.model, point, answer));
    for (const record::Note& one : session::warnings_on_point(file.model, point, answer))
      warn("raceway solve: " + one.text);
    return done;
  }
  const bearing::SolveReport& report = answer.equilibrium.report;
  complain(fmt::format(
      "raceway solve: {}: {} at {:.6g} rpm, {:.6g} N axial, {:.6g} N radial{}", flags.model,
      answer.why, flags.point.speed_rpm, point.axial_load, point.radial_load,
      report.status == bearing::SolveStatus::no_equilibrium
          ? session::words_of_absence(report, point)
      : report.status == bearing::SolveStatus::singular
          ? std::string(
                ": the balls that carry this load are too few to support the ring against tilt")
      : report.status != bearing::SolveStatus::not_finite
          ? fmt::format(" after {} Newton steps", report.iterations)
          : std::string()));
  return not_converged;
}

}  // namespace

Run setup_solve(CLI::App& command) {
  auto flags = std::make_shared<SolveFlags>();
  declare_model(command, flags->model);
  add_number(command, "--speed", flags->point.speed_rpm, speed_range, "shaft speed [rpm]")
      ->required();
  add_number(command, "--axial-load", flags->point.axial_load_N, signed_load_range,
             "axial load [N]; on a shaft positive towards the tool; default: value of the model");
  add_number(command, "--radial-load", flags->point.radial_load_N, load_range,
             "radial load along +y [N]; default: [rig] of the model, else 0");
  add_number(command, "--temperature", flags->point.temperature_C, temperature_range,
             "lubricant temperature [C]; default: [rig] of the model, else 40");
  add_number(command, "--moment-y", flags->point.moment_y_Nmm, moment_range,
             "moment about y [N mm]; needs [solver] tilt = \"free\"; default 0");
  add_number(command, "--moment-z", flags->point.moment_z_Nmm, moment_range,
             "moment about z [N mm]; needs [solver] tilt = \"free\"; default 0");
  flags->band.declare(command);
  declare_json(command, flags->json);
  command.footer(
      "Example:\n  raceway solve my.toml --speed 10000 --axial-load 600\n"
      "  raceway solve my.toml --speed 10000 --axial-load 600 --radial-load 100 --json");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
