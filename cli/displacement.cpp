#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "cli/axis_flag.h"
#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "session/bands.h"
#include "session/open_input.h"
#include "session/operating_point.h"
#include "session/shaft_curve.h"
#include "shaft/lift_off.h"
#include "shaft/shaft_balance.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct DisplacementFlags : ResultFlags {
  std::string model, speed;
  double axial_load = unset, temperature = unset;
  BandFlag band;
};

/// One value of an axis; none where the flag is not given.
std::vector<double> given(double value) {
  return std::isnan(value) ? std::vector<double>() : std::vector{value};
}

std::vector<shaft::ShaftPoint> points(const DisplacementFlags& f, const files::ModelFile& file) {
  const friction::TableAxes axes =
      session::table_axes(messages(), file,
                          {.speed_rpm = axis(f.speed, speed_range, "--speed"),
                           .axial_load_N = given(f.axial_load),
                           .radial_load_N = {},
                           .temperature_C = given(f.temperature)},
                          session::Wording::flags);
  if (axes.speed.size() > 1000000)
    throw text::InputError(
        fmt::format("raceway displacement: {} speeds are given; at most 1e6 are allowed",
                    axes.speed.size()),
        {.key = "--speed"});
  std::vector<shaft::ShaftPoint> result;
  for (const double speed : axes.speed)
    result.push_back({.speed = speed,
                      .external_load = axes.axial_load.front(),
                      .temperature = axes.temperature.front()});
  return result;
}

void print(const model::Model& model, const session::ShaftCurve& curve) {
  const std::vector<shaft::ShaftPoint>& asked = curve.points();
  const std::vector<shaft::ShaftPrediction>& predictions = curve.predictions();
  const results::BandOfResult* const band = curve.band();
  const bearing::Arrangement a = shaft::mounted_arrangement(model);
  const bearing::LiftOff free = lift_off(a);
  fmt::print("Shaft position of {} in its arrangement, positive towards the tool\n", model.name);
  fmt::print(
      "preload {:.4g} N at standstill; the front set loses contact at an external load of {} N, "
      "the rear set {}\n\n",
      a.preload(), number(free.front),
      std::isnan(free.rear) ? "at none" : fmt::format("at {} N", number(free.rear)));
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
  std::vector<shaft::ShaftPoint> asked = points(flags, file);
  const std::optional<model::Band> band = flags.band.of(file);
  const session::ShaftCurve curve(file, std::move(asked), band);
  flags.put_table([&] { return curve.csv(); }, fmt::format(", {} speeds", curve.points().size()));
  if (flags.json) {
    put_document(curve.json());
  } else if (flags.output.empty()) {
    print(file.model, curve);
    if (band) fmt::print("+-: {}\n", session::band_statement(*band));
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
