#include "session/sensitivity.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/axis_flag.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/progress.h"
#include "cli/sensitivity_text.h"
#include "cli/shared_flags.h"
#include "session/open_input.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

struct SensitivityFlags {
  std::string model;
  AxisFlags axes;
  std::vector<std::string> of, spread, data;
  std::size_t samples = 0;
  std::uint64_t seed = 1;
  bool steady = false, no_coolant = false, all = false, json = false;
};

/// Names with commas between them, of a flag that may be given several times.
std::vector<std::string> split(const std::vector<std::string>& lists) {
  std::vector<std::string> names;
  for (const std::string& list : lists)
    for (const std::string_view name : text::split(list, ',')) names.emplace_back(name);
  return names;
}

session::SensitivityQuestion question_of(const SensitivityFlags& f) {
  session::SensitivityQuestion q{
      .steady = f.steady, .coolant_on = !f.no_coolant, .samples = f.samples, .seed = f.seed};
  q.predictions = split(f.of);
  q.data = split(f.data);
  session::AskedAxes axes = f.axes.asked();
  q.speeds_rpm = std::move(axes.speed_rpm);
  q.axial_loads_N = std::move(axes.axial_load_N);
  q.radial_loads_N = std::move(axes.radial_load_N);
  q.temperatures_C = std::move(axes.temperature_C);
  for (const std::string& one : f.spread) {
    const auto more =
        one.find('=') == one.npos ? files::read_spreads(one) : files::parse_spreads(one);
    q.spreads.insert(q.spreads.end(), more.begin(), more.end());
  }
  return q;
}

int run(const SensitivityFlags& flags) {
  session::SensitivityQuestion question = question_of(flags);
  const files::ModelFile file =
      session::open_model(messages(), flags.model, session::Accepts::rig_or_shaft);
  std::optional<Progress> bar;
  if (shows_progress() && (flags.samples > 0 || flags.steady)) bar.emplace();
  if (bar)
    question.progress = [&](double share) {
      bar->show(std::min(share, 0.999), "varying the data");
    };
  const results::Sensitivity found = session::sensitivity(messages(), file, question);
  if (bar) bar->show(1.0);
  bar.reset();
  if (flags.json)
    put_document(results::sensitivity_json(found));
  else
    print_sensitivity(found, flags.all);
  warn(session::sensitivity_warnings(found));
  return found.converged() ? done : not_converged;
}

}  // namespace

Run setup_sensitivity(CLI::App& command) {
  auto flags = std::make_shared<SensitivityFlags>();
  declare_model(command, flags->model);
  command
      .add_option(
          "--of", flags->of,
          "predictions, separated by commas: torque, heat, displacement, contact-angle, stiffness, "
          "pressure, life; for shafts and spindles also preload and temperature; or columns of "
          "raceway solve. Default: torque; for a shaft: displacement")
      ->type_name("NAMES");
  flags->axes.declare(command,
                      "speeds [rpm]; write each axis as a list such as 100,300,900 or as a range "
                      "from:to:step such as 0:12000:2000");
  command.add_flag("--steady", flags->steady, "use the steady state of a whole spindle");
  command.add_flag("--no-coolant", flags->no_coolant, "with --steady: switch off the coolant flow");
  command
      .add_option("--spread", flags->spread,
                  "possible errors (plus or minus) as a list of NAME=ERROR, such as "
                  "ball_diameter_mm=0.01,viscosity_40C_mm2_s=10%; or a TOML file with errors under "
                  "the keys of the model. Default: 1 %, 1 K for temperatures, 1 for counts such as "
                  "ball_count, and sqrt(3) standard errors for fitted numbers")
      ->type_name("DATA");
  command
      .add_option("--data", flags->data,
                  "numbers to vary, separated by commas; the name of a table means all its "
                  "numbers, such as bearing,shaft; default: all numbers")
      ->type_name("NAMES");
  command
      .add_option("--global", flags->samples,
                  "number of samples for Sobol' indices, a power of two; needs SAMPLES x (count of "
                  "varied numbers + 2) evaluations")
      ->check(CLI::Range(std::size_t{2}, std::size_t{1} << 24U))
      ->type_name("SAMPLES");
  command.add_option("--seed", flags->seed, "random seed of the samples; default 1")
      ->type_name("N");
  command.add_flag("--all", flags->all,
                   "also list the numbers that each cause less than 0.1 % of the sum of the "
                   "squared changes of a prediction");
  declare_json(command, flags->json);
  command.footer(
      "Example:\n"
      "  raceway sensitivity my.toml --speed 10000 --axial-load 300\n"
      "  raceway sensitivity my.toml --of torque,stiffness --speed 10000 --axial-load 300 \\\n"
      "    --spread contact_angle_deg=1,viscosity_40C_mm2_s=10% --global 1024\n"
      "  raceway sensitivity spindle.toml --steady --speed 6000 --of displacement");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
