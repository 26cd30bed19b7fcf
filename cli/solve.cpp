#include <fmt/core.h>

#include <optional>

#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/roller_text.h"
#include "cli/shaft_text.h"
#include "cli/shared_flags.h"
#include "cli/state_text.h"
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

void print(const model::Model& model, const bearing::OperatingPoint& point,
           const session::PointAnswer& answer) {
  if (answer.shaft)
    print_shaft_state(model, point, *answer.shaft);
  else if (model.bearing.rollers())
    print_roller_state(model, point, answer);
  else
    print_state(model, point, answer);
}

int run(const SolveFlags& flags) {
  const files::ModelFile file =
      session::open_model(messages(), flags.model, session::Accepts::rig_or_shaft);
  session::warn_of_ignored_data(messages(), file);
  const std::optional<model::Band> band = flags.band.of(file);
  const bearing::OperatingPoint point =
      session::operating_point(messages(), file, flags.point, session::Wording::flags);
  const session::PointAnswer answer = session::solve_point(file.model, point, band);
  if (flags.json) put_document(session::point_json(file.model, point, answer));
  if (!answer.converged()) {
    complain(fmt::format("raceway solve: {}: {}", flags.model, answer.why));
    return not_converged;
  }
  if (!flags.json) print(file.model, point, answer);
  if (!flags.json && band) print_band(*band, answer);
  tell(session::notes_on_point(file.model, point, answer));
  return done;
}

}  // namespace

Run setup_solve(CLI::App& command) {
  auto flags = std::make_shared<SolveFlags>();
  declare_model(command, flags->model);
  add_number(command, "--speed", flags->point.speed_rpm, speed_range, "shaft speed [rpm]")
      ->required();
  add_number(command, "--axial-load", flags->point.axial_load_N, signed_load_range,
             "axial load [N] (of a shaft: positive towards the tool); default: axial_load_N or "
             "external_load_N of the model");
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
