#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "cli/axis_flag.h"
#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "session/bands.h"
#include "session/open_input.h"
#include "session/shaft_curve.h"

namespace raceway::cli {
namespace {

struct DisplacementFlags : ResultFlags {
  std::string model, speed;
  double axial_load = unset, temperature = unset;
  BandFlag band;
};

void print(const std::string& name, const session::ShaftCurve& curve) {
  const std::vector<shaft::ShaftPoint>& asked = curve.points();
  const std::vector<shaft::ShaftPrediction>& predictions = curve.predictions();
  const results::BandOfResult* const band = curve.band();
  const bearing::Arrangement mounted = curve.mounted();
  const bearing::LiftOff free = lift_off(mounted);
  fmt::print("Shaft position of {} in its arrangement, positive towards the tool\n", name);
  fmt::print(
      "preload {:.4g} N at standstill; the front set loses contact at an external load of {} N, "
      "and the rear set {}\n\n",
      mounted.preload(), number(free.front),
      std::isnan(free.rear) ? "at no load" : fmt::format("at {} N", number(free.rear)));
  // A number, and behind it how sure it is.
  const auto with_band = [&](std::string text, std::size_t row, std::size_t number_of_row,
                             double unit) {
    return band ? text + " " + band_text(band->half_widths[3 * row + number_of_row], unit) : text;
  };
  TextTable table({{"speed", "rpm"},
                   {"position", "um"},
                   {"front", "N"},
                   {"rear", "N"},
                   {"stiffness", "N/um"},
                   {"torque", "N mm"},
                   {"loss", "W"}});
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const shaft::ShaftPrediction& p = predictions[k];
    table.add({fmt::format("{:.6g}", asked[k].speed / rpm),
               p.equilibrium.report.converged()
                   ? with_band(fmt::format("{:.4f}", p.displacement / um), k, 0, um)
                   : "-",
               number(p.equilibrium.front_force), number(p.equilibrium.rear_force),
               number(p.equilibrium.axial_stiffness / N_per_um),
               with_band(number(p.torque / N_mm), k, 1, N_mm),
               with_band(number(p.power_loss), k, 2, 1.0)});
  }
  fmt::print("{}", table.text(terminal_width()));
}

int run(const DisplacementFlags& flags) {
  flags.check_results("displacement");
  const files::ModelFile file =
      session::open_model(messages(), flags.model, session::Accepts::shaft);
  const session::CurveQuestion question{.speed_rpm = axis(flags.speed, speed_range, "--speed"),
                                        .axial_load_N = flags.axial_load,
                                        .temperature_C = flags.temperature,
                                        .band = flags.band.of(file),
                                        .wording = session::Wording::flags};
  const session::ShaftCurve curve(messages(), file, question);
  flags.put_table([&] { return curve.csv(); }, fmt::format(", {} speeds", curve.points().size()));
  if (flags.json) {
    put_document(curve.json());
  } else if (flags.output.empty()) {
    print(file.model.name, curve);
    if (question.band) fmt::print("+-: {}\n", session::band_statement(*question.band));
  }
  flags.put_page([&] { return curve.page(); });
  tell(curve.warnings());
  return curve.converged() ? done : not_converged;
}

}  // namespace

Run setup_displacement(CLI::App& command) {
  auto flags = std::make_shared<DisplacementFlags>();
  declare_model(command, flags->model, "an [arrangement]");
  command
      .add_option(
          "--speed", flags->speed,
          "speeds [rpm]: a list such as 100,300,900 or a range from:to:step such as 0:10000:250")
      ->required()
      ->type_name("VALUES");
  add_number(command, "--axial-load", flags->axial_load, signed_load_range,
             "axial load [N], positive towards the tool; default: external_load_N of the model");
  add_number(command, "--temperature", flags->temperature, temperature_range,
             "lubricant temperature [C]; default: [rig] of the model, else 40");
  flags->band.declare(command);
  flags->declare_output(command, "CSV file to write; - for stdout");
  flags->declare_results(command);
  command.footer("Example:\n  raceway displacement my.toml --speed 0:10000:250 -o kinematic.csv");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
