#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <optional>

#include "cli/axis_flag.h"
#include "cli/commands.h"
#include "cli/number_flag.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "session/open_input.h"
#include "session/spindle_modes.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct ModesFlags : ResultFlags {
  std::string model, speed, shapes;
  int count = 6;
  double damping = unset, unbalance_gmm = unset, unbalance_at_mm = 0.0;
  bool warm = false, coolant_on = true;
};

std::vector<double> campbell_speeds(const ModesFlags& f) {
  std::vector<double> speeds = axis(f.speed, speed_range, "--speed");
  require_all(speeds, speed_range, "--speed");
  for (double& speed : speeds) speed *= rpm;
  return speeds;
}

std::optional<spindle::Unbalance> unbalance_of(const ModesFlags& f) {
  if (std::isnan(f.unbalance_gmm)) return std::nullopt;
  return spindle::Unbalance{.size = f.unbalance_gmm * 1e-3 * mm,
                            .position = f.unbalance_at_mm * mm,
                            .damping_ratio = f.damping};
}

/// Prints one line for each speed at which an excitation meets a mode.
void print_crossings(const std::vector<results::ModesAtSpeed>& speeds) {
  TextTable table(
      {{"excitation", "", true}, {"mode", "", true}, {"speed", "rpm"}, {"frequency", "Hz"}});
  const std::vector<results::Crossing> found = results::crossings(speeds);
  for (const results::Crossing& c : found)
    table.add({c.excitation, fmt::format("{} {}", c.mode, spindle::name(c.whirl)),
               fmt::format("{:.0f}", c.speed / rpm),
               fmt::format("{:.1f}", c.frequency / (2.0 * pi))});
  if (!found.empty())
    fmt::print("\nspeeds at which an excitation has the frequency of a mode\n\n{}",
               table.text(terminal_width()));
}

void print(const ModesFlags& f, const session::SpindleModes& found) {
  const bearing::Arrangement& a = found.beam.sets.arrangement();
  fmt::print(
      "Modes of {} on its bearings, shaft mass {:.4g} kg{}: frequency in Hz, b backward whirl, f "
      "forward whirl\n",
      found.file.model.name, found.beam.beam.weight(),
      f.warm ? ", warm in the steady state" : ", cold");
  fmt::print("preload {:.4g} N at standstill\n\n", a.preload());
  std::vector<TextTable::Column> columns{{"speed", "rpm"}, {"front", "N"}, {"rear", "N"}};
  for (std::size_t i = 0; i < a.bearings().size(); ++i)
    columns.push_back({fmt::format("K {}", i + 1), "N/um"});
  for (const std::string& name : found.beam.roller_names)
    columns.push_back({fmt::format("K {}", name), "N/um"});
  for (int k = 1; k <= f.count; ++k) columns.push_back({fmt::format("f{}", k), "Hz"});
  if (!std::isnan(f.unbalance_gmm)) columns.push_back({"nose", "um"});
  TextTable table(columns);
  for (const results::ModesAtSpeed& r : found.speeds) {
    const bool known = r.sets.converged();
    std::vector<std::string> row{fmt::format("{:.6g}", r.speed / rpm),
                                 number(known ? r.sets.equilibrium.front_force : unset),
                                 number(known ? r.sets.equilibrium.rear_force : unset)};
    for (std::size_t i = 0; i < a.bearings().size(); ++i)
      row.push_back(number(known ? r.sets.bearings[i].stiffness(1, 1) / N_per_um : unset));
    for (std::size_t i = 0; i < found.beam.roller_names.size(); ++i)
      row.push_back(
          number(known && r.shaft ? r.shaft->rollers[i].stiffness(0, 0) / N_per_um : unset));
    for (std::size_t k = 0; k < static_cast<std::size_t>(f.count); ++k) {
      if (k >= r.modes.modes.size()) {
        row.emplace_back("-");
        continue;
      }
      const spindle::Mode& mode = r.modes.modes[k];
      row.push_back(fmt::format("{:.1f} {}", mode.frequency / (2.0 * pi),
                                mode.whirl == spindle::Whirl::backward  ? "b"
                                : mode.whirl == spindle::Whirl::forward ? "f"
                                                                        : " "));
    }
    if (r.nose) row.push_back(number(r.nose->amplitude / um));
    table.add(std::move(row));
  }
  fmt::print("{}", table.text(terminal_width()));
  fmt::print("\nfront, rear: forces of the bearing sets; K: radial stiffness of each bearing\n");
  if (!std::isnan(f.unbalance_gmm))
    fmt::print(
        "nose: amplitude with an unbalance of {:.6g} g mm at {:.6g} mm behind the nose face and a "
        "damping ratio of {:.6g}\n",
        f.unbalance_gmm, f.unbalance_at_mm, f.damping);
  print_crossings(found.speeds);
}

int run(const ModesFlags& f) {
  if (f.json && f.shapes == "-")
    throw text::InputError(
        "raceway modes: both --json and \"--shapes -\" write to stdout; omit one of them",
        {.key = "--shapes"});
  f.check_results("modes");
  f.csv.require_writable(f.shapes, f.if_exists());
  const files::ModelFile file = session::open_model(messages(), f.model, session::Accepts::shaft);
  const session::SpindleModes found = session::spindle_modes(file, {.speeds = campbell_speeds(f),
                                                                    .warm = f.warm,
                                                                    .coolant_on = f.coolant_on,
                                                                    .count = f.count,
                                                                    .damping_ratio = f.damping,
                                                                    .unbalance = unbalance_of(f)});
  const std::string what = fmt::format(", {} speeds", found.speeds.size());
  f.put_table([&] { return found.csv(); }, what);
  if (!f.shapes.empty()) f.csv.put(f.shapes, found.shapes_csv(), f.if_exists(), what);
  if (f.json)
    put_document(found.json());
  else if (f.output.empty() && f.shapes.empty())
    print(f, found);
  return f.finish(found);
}

}  // namespace

Run setup_modes(CLI::App& command) {
  auto flags = std::make_shared<ModesFlags>();
  declare_model(command, flags->model, "[arrangement] and [shaft]");
  command
      .add_option(
          "--speed", flags->speed,
          "speeds [rpm]: a list such as 0,6000 or a range from:to:step such as 0:20000:1000")
      ->required()
      ->type_name("VALUES");
  command.add_flag("--warm", flags->warm,
                   "use the bearing stiffness of the warm spindle in its steady state");
  declare_coolant(command, flags->coolant_on, "coolant of the warm spindle, on or off; default on");
  command.add_option("--modes", flags->count, "number of modes; default 6")
      ->check(CLI::Range(1, 40))
      ->type_name("N");
  add_number(command, "--damping", flags->damping, {0.0, 1.0, ""},
             "damping ratio of all modes, such as 0.02; needed for --unbalance");
  add_number(command, "--unbalance", flags->unbalance_gmm, {0.0, 1e9, "g mm"},
             "unbalance of the shaft [g mm], for the amplitude of the nose at each speed");
  add_number(command, "--unbalance-at", flags->unbalance_at_mm, {0.0, 1e5, "mm"},
             "position of the unbalance behind the nose face [mm]; default 0");
  flags->declare_output(command, "CSV file for the Campbell diagram; - for stdout");
  command
      .add_option("--shapes", flags->shapes, "CSV file for the shapes of the modes; - for stdout")
      ->type_name("FILE");
  flags->declare_results(command);
  command.footer(
      "Example:\n  raceway modes spindle.toml --speed 0:20000:1000 -o campbell.csv --report "
      "page.html");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
