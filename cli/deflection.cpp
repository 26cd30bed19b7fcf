#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/commands.h"
#include "cli/number_flag.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "results/shaft_results.h"
#include "session/open_input.h"
#include "session/spindle_deflection.h"

namespace raceway::cli {
namespace {

struct DeflectionFlags : ResultFlags {
  DeflectionFlags() { force_flag = "--replace"; }  // --force is the load

  std::string model, direction = "radial";
  double force_N = 0.0, axial_force_N = 0.0, moment_Nm = 0.0, at_mm = 0.0, speed_rpm = 0.0;
  bool warm = false, coolant_on = true;
};

/// As text, zero where rounding left it.
std::string across(double first, double second, const results::DeflectionResult& r) {
  const double value = std::hypot(first, second);
  const double load = std::abs(r.force) + std::abs(r.axial_force) + std::abs(r.moment);
  return number(value < 1e-9 * load ? 0.0 : value);
}

void print(const DeflectionFlags& f, const session::SpindleDeflection& found) {
  const results::DeflectionResult& r = found.result;
  const bearing::Arrangement& a = found.beam.sets.arrangement();
  fmt::print("Deflection of {} under {} at {:.6g} mm behind the nose face, {:.6g} rpm, {}\n",
             found.file.model.name, results::load_words(r), f.at_mm, f.speed_rpm,
             f.warm ? "warm" : "cold");
  if (r.sets.converged())
    fmt::print(
        "preload {:.4g} N as mounted; forces of the bearing sets at this speed, without the "
        "external load: front {} N, rear {} N\n",
        a.preload(), number(r.sets.equilibrium.front_force), number(r.sets.equilibrium.rear_force));
  if (!r.converged()) return;
  if (std::isnan(r.stiffness()))
    fmt::print("displacement at the load {:.4f} um ({:.4f} um with the stiffness at zero load)\n",
               r.displacement / um, r.tangent / um);
  else
    fmt::print("displacement at the load {:.4f} um, stiffness {} N/um (at zero load {} N/um)\n",
               r.displacement / um, number(r.stiffness() / N_per_um),
               number(r.force / r.tangent / N_per_um));
  if (!r.axial)
    fmt::print("radial displacement of the nose {:.4f} um, slope {:.3f} urad\n", r.nose / um,
               r.slope * 1e6);
  fmt::print("\n");
  TextTable table({{"bearing", "", true},
                   {"axial", "N"},
                   {"radial", "N"},
                   {"moment", "N m"},
                   {"ball from", "N"},
                   {"to", "N"},
                   {"angle from", "deg"},
                   {"to", "deg"},
                   {"lost balls", ""},
                   {"K axial", "N/um"},
                   {"K radial", "N/um"},
                   {"no load", "N/um"}});
  for (std::size_t i = 0; i < r.shaft.bearings.size(); ++i) {
    const bearing::BearingEquilibrium& e = r.shaft.bearings[i];
    const bearing::Vector5& load = r.shaft.loads[i];
    double least = 1e300, most = 0.0, flattest = unset, steepest = unset;
    for (const bearing::BallEquilibrium& ball : e.balls) {
      least = std::min(least, ball.inner_load);
      most = std::max(most, ball.inner_load);
      flattest = std::fmin(flattest, ball.inner_contact_angle);
      steepest = std::fmax(steepest, ball.inner_contact_angle);
    }
    table.add({results::bearing_place(a, i), number(load[0]), across(load[1], load[2], r),
               across(load[3], load[4], r), number(least), number(most), number(flattest / degree),
               number(steepest / degree), fmt::format("{}", e.lost_balls()),
               number(e.stiffness(0, 0) / N_per_um), number(e.stiffness(1, 1) / N_per_um),
               number(r.sets.bearings[i].stiffness(1, 1) / N_per_um)});
  }
  fmt::print("{}", table.text(terminal_width()));
  if (r.shaft.rollers.empty()) return;
  TextTable rollers({{"roller bearing", "", true},
                     {"clearance", "um"},
                     {"radial", "N"},
                     {"no load", "N"},
                     {"moment", "N m"},
                     {"loaded", "rollers"},
                     {"K radial", "N/um"},
                     {"no load", "N/um"}});
  for (std::size_t i = 0; i < r.shaft.rollers.size(); ++i) {
    const bearing::RollerEquilibrium &e = r.shaft.rollers[i], &before = r.unloaded->rollers[i];
    rollers.add({r.roller_names[i], number(e.clearance / um),
                 number(std::hypot(e.load[0], e.load[1])),
                 number(std::hypot(before.load[0], before.load[1])),
                 number(std::hypot(e.load[2], e.load[3])), fmt::format("{}", e.loaded_rollers()),
                 number(e.stiffness(0, 0) / N_per_um), number(before.stiffness(0, 0) / N_per_um)});
  }
  fmt::print("\n{}", rollers.text(terminal_width()));
}

int run(const DeflectionFlags& f) {
  f.check_results("deflection");
  const session::DeflectionQuestion question{.force = f.force_N,
                                             .axial = f.direction == "axial",
                                             .axial_force = f.axial_force_N,
                                             .moment = f.moment_Nm,
                                             .at = f.at_mm * mm,
                                             .speed = f.speed_rpm * rpm,
                                             .warm = f.warm,
                                             .coolant_on = f.coolant_on,
                                             .wording = session::Wording::flags};
  session::check(question);
  const files::ModelFile file = session::open_model(messages(), f.model, session::Accepts::shaft);
  const session::SpindleDeflection found = session::spindle_deflection(file, question);
  f.put_table([&] { return found.csv(); },
              fmt::format(", {} places", found.beam.beam.nodes().size()));
  if (f.json)
    put_document(found.json());
  else if (f.output.empty())
    print(f, found);
  return f.finish(found);
}

}  // namespace

Run setup_deflection(CLI::App& command) {
  auto flags = std::make_shared<DeflectionFlags>();
  declare_model(command, flags->model, "[arrangement] and [shaft]");
  add_number(command, "--force", flags->force_N, signed_load_range,
             "force [N]; axial: positive towards the tool; default 0");
  add_number(command, "--axial-force", flags->axial_force_N, signed_load_range,
             "axial force [N] in addition to a radial force, positive towards the tool");
  add_number(command, "--moment", flags->moment_Nm, session::moment_load_range,
             "moment at the position --at [N m]; a positive moment turns the shaft like a positive "
             "radial force in front of this position");
  add_number(command, "--at", flags->at_mm, session::at_range,
             "position of the force behind the nose face [mm]; default 0");
  command
      .add_option("--direction", flags->direction,
                  "direction of the force: radial or axial; default radial")
      ->check(CLI::IsMember({"radial", "axial"}))
      ->type_name("WORD");
  add_number(command, "--speed", flags->speed_rpm, speed_range, "speed [rpm]; default 0");
  command.add_flag("--warm", flags->warm,
                   "use the preload of the warm spindle in its steady state at --speed");
  declare_coolant(command, flags->coolant_on, "coolant of the warm spindle, on or off; default on");
  flags->declare_output(command, "CSV file for the bending line; - for stdout");
  flags->declare_results(command);
  command.footer(
      "Example:\n  raceway deflection spindle.toml --force 1000 --axial-force -300 --moment 100 "
      "--speed 8000 --warm");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
