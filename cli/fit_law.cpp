#include <fmt/core.h>
#include <unistd.h>

#include <cmath>
#include <optional>

#include "cli/commands.h"
#include "cli/number_flag.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "session/law_fit.h"
#include "session/reading.h"
#include "shaft/displacement_table.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct FitLawFlags : OutputFlags {
  std::string curve;
  double at = unset;  // [rpm]
  bool json = false;
  session::Reading reading;
};

void print(const shaft::KinematicLawFit& f, const std::string& source,
           const std::optional<results::LawAtSpeed>& at, const std::string& statement) {
  fmt::print("u = A n^(1 - B exp(-C n)), displacement u in um, speed n in rpm, fitted to {}\n\n",
             source);
  TextTable table({{"parameter", "", true}, {"value", ""}, {"std error", ""}, {"unit", "", true}});
  for (const record::Parameter& p : f.parameters)
    table.add({p.name, number(p.value, 6), number(p.std, 2), p.unit == "1" ? "-" : p.unit});
  fmt::print("{}", table.text(terminal_width()));
  if (!std::isnan(f.correlation(0, 1)) && !std::isnan(f.correlation(0, 2)))
    fmt::print("correlation of A and B {:.2f}, A and C {:.2f}, B and C {:.2f}\n",
               f.correlation(0, 1), f.correlation(0, 2), f.correlation(1, 2));
  fmt::print("\nmean absolute error  {} um over {} rows\n", number(f.mae / um, 3), f.rows);
  fmt::print("largest error        {} um at {:.6g} rpm\n", number(f.max_abs / um, 3),
             f.speed_of_max_abs / rpm);
  fmt::print("valid                {:.6g} to {:.6g} rpm\n", f.law.lowest_speed / rpm,
             f.law.highest_speed / rpm);
  if (at)
    fmt::print("\nat {:.6g} rpm: u = {:.7g} um, du/dn = {:.6g} um/rpm\n", at->speed / rpm,
               at->value.displacement / um, at->value.slope / (um / rpm));
  fmt::print("\n{}\n", statement);
}

int run(const FitLawFlags& flags) {
  if (flags.curve == "-" && isatty(STDIN_FILENO) != 0)
    throw text::InputError(
        "raceway fit-law: CSV is missing, and standard input is a terminal; name a file",
        {.key = "CSV"});
  refuse_two_on_stdout("fit-law", flags.json, flags.output);
  flags.require_writable();

  const session::LawFit found = session::fit_law(messages(), flags.curve, flags.reading, flags.at);
  const shaft::KinematicLawFit& f = found.fit;
  const files::DisplacementCurve& curve = found.curve;
  const std::string table_file = flags.output.empty() ? "-o FILE writes the table" : flags.output;
  if (flags.json) {
    put_document(found.json(table_file));
  } else if (f.converged() && flags.output != "-") {
    print(f, curve.source, found.at, found.statement(table_file));
  }
  // The table rests on the rows alone and is written also where no law was found.
  if (!flags.output.empty()) {
    const shaft::DisplacementTable table = shaft::make_displacement_table(curve.points);
    flags.put(files::displacement_table_text(table, curve.source),
              fmt::format(", {} speeds", table.speed.size()));
    if (!table.monotone)
      warn(
          "the table is not monotone: with rising speed, the displacement both rises and falls; "
          "check whether this is real or scatter of the readings");
  }
  if (f.converged()) return done;
  complain(fmt::format("raceway fit-law: the fit ended with status {} after {} steps",
                       fit::name(f.status), f.iterations));
  return not_converged;
}

}  // namespace

Run setup_fit_law(CLI::App& command) {
  auto flags = std::make_shared<FitLawFlags>();
  flags->curve = "-";
  command
      .add_option("CSV", flags->curve,
                  "CSV with speed_rpm, axial_displacement_um and, if known, std_um; with - or "
                  "without CSV, the command reads stdin")
      ->type_name("");
  add_number(command, "--at", flags->at, speed_range,
             "also print displacement and slope at this speed [rpm]");
  flags->declare_output(command,
                        "file for a table of displacement over speed, for curves that the law does "
                        "not fit; - for stdout");
  declare(command, flags->reading);
  flags->declare_force(command);
  declare_json(command, flags->json);
  command.footer(
      "Example:\n  raceway fit-law kinematic.csv --at 5000\n"
      "  raceway displacement spindle.toml --speed 0:10000:250 -o - | raceway fit-law");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
