#include "verdict/calibrate.h"

#include <fmt/core.h>

#include <cmath>

#include "cli/calibrate_conformity.h"
#include "cli/commands.h"
#include "cli/error_text.h"
#include "cli/fitted_models.h"
#include "cli/output_flags.h"
#include "cli/text_table.h"
#include "session/loop.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct CalibrateFlags : OutputFlags {
  std::string model;
  session::LoopOptions loop;
  std::vector<std::string> data;
  bool json = false, profile = false;
};

std::string remark(const fit::Parameter& p) {
  if (p.held && p.prior.is_known()) return "at its prior";
  if (p.held) return "held: not identifiable";
  if (!p.identifiable) return "not identifiable";
  return p.at_bound != fit::Bound::none ? "at its bound" : "";
}

std::string end_text(double value, bool open) {
  if (std::isinf(value)) return "open";
  return number(value, 5) + (open ? " (bound)" : "");
}

void print_parameters(const verdict::Calibration& c) {
  const bool profile = !c.profile.empty();
  std::vector<TextTable::Column> columns{
      {"parameter", "", true}, {"before", ""}, {"after", ""}, {"std error", ""}};
  if (profile) columns.insert(columns.end(), {{"95 % from", ""}, {"to", ""}});
  columns.insert(columns.end(), {{"unit", "", true}, {"", "", true}});
  TextTable table(columns);
  for (std::size_t k = 0; k < c.parameters.size(); ++k) {
    const fit::Parameter& p = c.parameters[k];
    std::vector<std::string> row{p.name, number(p.start), number(p.value, 5), number(p.std, 2)};
    if (profile) {
      const fit::ProfileInterval& of = c.profile[k];
      row.push_back(end_text(of.lower, of.open_lower));
      row.push_back(end_text(of.upper, of.open_upper));
    }
    row.push_back(p.unit == "1" ? "-" : p.unit);
    row.push_back(remark(p));
    table.add(std::move(row));
  }
  fmt::print("{}", table.text(terminal_width()));
  if (!profile) return;
  fmt::print(
      "95 %: interval in which chi2 (weighted sum of squared residuals) is at most {:.4g}{} above "
      "its minimum, with all other parameters refitted\n",
      fit::profile_rise * c.error_factor * c.error_factor,
      c.error_factor == 1.0 ? "" : " (3.84 times the reduced chi2)");
}

void print(const verdict::Calibration& c) {
  print_parameters(c);
  // Numbers of two records hardly know of each other.
  constexpr double worth_a_line = 0.005;
  for (Eigen::Index i = 0; i < c.correlation.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (std::abs(c.correlation(i, j)) >= worth_a_line)
        fmt::print("correlation of {} and {}: {:.2f}\n",
                   c.parameters[static_cast<std::size_t>(j)].name,
                   c.parameters[static_cast<std::size_t>(i)].name, c.correlation(i, j));
  fmt::print("\n");
  for (const verdict::ChannelError& e : c.channels)
    fmt::print("RMS error{} over {} rows: {} {} before, {} {} after\n",
               c.channels.size() > 1 ? fmt::format(" of {}", e.channel->words) : "", c.rows,
               error_text(e.rmse_before, *e.channel), error_unit(*e.channel),
               error_text(e.rmse_after, *e.channel), error_unit(*e.channel));
}

int run(const CalibrateFlags& flags) {
  flags.refuse_stdout("calibrate", "the parameters");
  if (flags.data.empty() && !flags.loop.per_record.empty())
    throw text::InputError("raceway calibrate: --per-record needs measurements: DATA is missing",
                           {.key = "DATA"});
  if (flags.data.empty() && flags.profile)
    throw text::InputError("raceway calibrate: --profile needs measurements: DATA is missing",
                           {.key = "DATA"});
  if (flags.data.empty()) return calibrate_conformity(flags.model, flags, flags.json);
  if (flags.loop.per_record.empty()) flags.require_writable();
  const session::LoopQuestion asked =
      session::ask(messages(), flags.model, session::files(flags.data), flags.loop);
  const FittedModels output(flags);
  output.require_writable(*asked.subject);
  const verdict::Calibration found = session::calibrate(asked, {.profile = flags.profile});
  if (flags.json) {
    put_document(session::json(asked, found));
  } else if (found.converged()) {
    print(found);
  }
  tell(found.messages);
  if (!found.converged()) {
    complain(fmt::format(
        "raceway calibrate: the fit ended with status {} after {} steps; {}",
        fit::name(found.status), found.iterations,
        flags.output.empty() ? "no result" : output.names(*asked.subject) + " is not written"));
    return not_converged;
  }
  output.write(asked, found);
  return done;
}

}  // namespace

Run setup_calibrate(CLI::App& command) {
  auto flags = std::make_shared<CalibrateFlags>();
  command
      .add_option("MODEL", flags->model,
                  "model file (TOML); without DATA, also a designation from the catalogue")
      ->required()
      ->type_name("");
  command
      .add_option(
          "DATA", flags->data,
          "measurements (CSV), one or more files; default: the axial rigidities in the catalogue")
      ->type_name("")
      ->expected(-1);
  flags->declare_output(command,
                        "model file to write: MODEL with the fitted values; with --per-record, one "
                        "file for each record, named FILE-RECORD.toml");
  declare(command, flags->loop);
  command.add_flag("--profile", flags->profile,
                   "also print the 95 % interval of each parameter (profile likelihood)");
  flags->declare_force(command);
  declare_json(command, flags->json);
  command.footer(
      "The key free in the table [calibration] of MODEL lists the parameters to fit.\nDefault: the "
      "usual parameters of the law, such as f0 and z; for a spindle, only the\nfirst of these "
      "parameters; for another shaft with preload_N, only preload_N.\n\nWithout DATA, the command "
      "fits the groove conformity, which makers do not print, to\nthe axial rigidities of the "
      "bearing in the catalogue.\n\nExample:\n  raceway calibrate my.toml rig.csv -o fitted.toml\n "
      " raceway calibrate my.toml monday.csv friday.csv --per-record f0,z -o fitted.toml\n  "
      "raceway calibrate \"S 6014 C\" -o my.toml");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
