#include "fit/check.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/commands.h"
#include "cli/error_text.h"
#include "cli/messages.h"
#include "cli/run_files.h"
#include "cli/shared_flags.h"
#include "cli/text_table.h"
#include "correction/record_check.h"
#include "io/error.h"
#include "io/names.h"
#include "io/number_text.h"
#include "io/output_file.h"
#include "io/record_text.h"
#include "io/results.h"
#include "io/subject.h"
#include "io/suggest_columns.h"
#include "session/correction_loop.h"
#include "session/open_input.h"
#include "session/reading.h"

namespace raceway::cli {
namespace {

std::string noise_text(const fit::Check::MeasuredChannel& m) {
  const auto text = [&](double rms) {
    return fmt::format("{} {} rms", error_text(rms, *m.channel, 3), error_unit(*m.channel));
  };
  const std::string stated = std::isnan(m.noise.rms) ? "not known (no std column, no repeated rows)"
                                                     : fmt::format("{} ({})", text(m.noise.rms),
                                                                   fit::name(m.noise.source));
  // Where it is the same there is nothing more to say.
  if (std::isnan(m.found_noise) || std::abs(m.found_noise - m.noise.rms) < 1e-3 * m.found_noise)
    return stated;
  return fmt::format("{}; calibrate and diagnose find {}", stated, text(m.found_noise));
}

void print_measured(const fit::Check& c, const record::Record& data) {
  const std::vector<fit::Check::MeasuredChannel>& measured = c.measured;
  std::vector<std::string_view> words;
  for (const fit::Check::MeasuredChannel& m : measured) words.push_back(m.channel->words);
  fmt::print("{}: {} row{} of {}{}\n", data.source, c.rows, c.rows == 1 ? "" : "s",
             fmt::join(words, ", "),
             c.runs == 0   ? ""
             : c.runs == 1 ? ", one run"
                           : fmt::format(", {} runs", c.runs));
  for (const fit::Check::MeasuredChannel& m : measured)
    fmt::print("noise{}: {}\n", measured.size() > 1 ? fmt::format(" of {}", m.channel->words) : "",
               noise_text(m));
}

void print(const fit::Check& c, const record::Record& data) {
  print_measured(c, data);
  TextTable columns({{"column", "", true}, {"from", ""}, {"to", ""}, {"levels", ""}});
  for (const fit::Check::Column& column : c.columns)
    columns.add(
        {std::string(column.channel->name), number(column.channel->in_unit(column.lower), 5),
         number(column.channel->in_unit(column.upper), 5), fmt::format("{}", column.levels)});
  fmt::print("\n{}\n", columns.text(terminal_width()));
  for (const fit::Parameter& p : c.free)
    fmt::print("free parameter {}: {}\n", p.name,
               p.identifiable ? "can be fitted" : "cannot be told from these data");
  for (const fit::Check::Testable& t : c.catalogue)
    fmt::print("effect {}: {}\n", t.id,
               !t.ruled_out.empty() ? "not testable: " + t.ruled_out
               : !t.missing.empty() ? "needs " + t.missing
               : !t.levels.empty()  ? "testable, but hard to tell apart without " + t.levels
                                    : "testable");
}

/// A map of the columns of the file on stdout.
int suggest(const std::string& model, const std::string& path) {
  if (path.ends_with(".toml"))
    throw io::InputError(path + ": stands where measurements (CSV) are expected", {.file = path});
  const io::ModelFile file = session::open_model(messages(), model, session::Accepts::rig_or_shaft);
  fmt::print("{}", io::suggested_columns(path, *io::make_subject(file.model)));
  return done;
}

struct CheckFlags {
  std::string model, data, output, displacement;
  session::Reading reading;
  bool json = false, suggest = false, force = false;
};

/// What the model leaves to the program.
void print_defaults(const std::string& source, const std::vector<std::string>& defaults) {
  fmt::print("{}: {} default{}\n", source, defaults.size(), defaults.size() == 1 ? "" : "s");
  for (const std::string& d : defaults) fmt::print("  {}\n", d.substr(0, d.find(" (default)")));
}

int run_model(const io::ModelFile& file, bool json) {
  if (json)
    put_document(io::model_check_json(file.model.name, file.defaults, file.notes));
  else
    print_defaults(file.source, file.defaults);
  return done;
}

/// What a record over time can tell, in lines.
void print(const correction::RecordCheck& c) {
  fmt::print(
      "rows every {:.4g} s over {:.4g} h, {} readings every {:.4g} s: time constants of {:.3g} s "
      "to "
      "{:.3g} s can be told\n",
      c.sampling, c.duration / 3600.0, c.readings, c.reading_interval, c.shortest, c.longest);
  for (const correction::RecordCheck::Quantum& q : c.quanta)
    fmt::print("{}: last digit {:.3g} {}\n", q.column->name, q.step / q.column->factor,
               io::difference_unit(*q.column));
  for (const correction::RecordCheck::Printed& p : c.printed) {
    std::vector<std::string> lags;
    for (const double tau : p.check.time_constants)
      lags.push_back(std::isfinite(tau) ? fmt::format("{:.4g} s", tau) : "no decay");
    fmt::print(
        "channel {}: poles of {}, DC gain {:.4g} um per unit ({:.4g} to {:.4g} as printed)\n",
        p.channel, fmt::join(lags, ", "), p.check.dc_gain / um, p.check.dc_gain_lower / um,
        p.check.dc_gain_upper / um);
  }
}

int check_corrections(const CheckFlags& flags, io::IfExists if_exists) {
  if (flags.data.empty()) {
    const io::CorrectionFile file = io::read_correction(flags.model);
    for (const std::string& table : file.tables) add_input(table);
    std::vector<std::string> names;
    for (const correction::Model& m : file.models) names.push_back(m.name);
    if (flags.json) {
      put_document(io::model_check_json(io::listed(names), file.defaults, file.notes));
    } else {
      tell(file.notes);
      print_defaults(file.source, file.defaults);
    }
    return done;
  }
  const session::CheckedCorrection checked = session::check_correction(
      messages(), flags.model, session::files({flags.data}), flags.displacement, flags.reading);
  const session::CorrectionQuestion& asked = checked.asked;
  if (flags.json) {
    put_document(checked.json());
  } else {
    print(checked.check, asked.data);
    fmt::print("\n");
    print(checked.over_time);
    fmt::print("\n");
    print_defaults(asked.file.source, asked.file.defaults);
  }
  if (!flags.output.empty()) {
    io::write_text(flags.output, io::record_text(asked.data), if_exists);
    say(fmt::format("{} written, {} rows", flags.output, asked.data.rows()));
  }
  return done;
}

int run(const CheckFlags& flags) {
  const auto if_exists = flags.force ? io::IfExists::replace : io::IfExists::refuse;
  if (flags.output == "-")
    throw io::InputError("raceway check: --output -: stdout shows what was read; name a file",
                         {.key = "--output"});
  if (!flags.output.empty()) io::require_writable(flags.output, if_exists);
  std::vector<std::string> data_files;
  if (!flags.data.empty()) data_files.push_back(flags.data);
  if (io::takes_correction(flags.model, data_files)) return check_corrections(flags, if_exists);
  const std::string& model = flags.model;
  const io::ModelFile file = session::open_model(messages(), model, session::Accepts::rig_or_shaft,
                                                 session::Defaults::keep);
  {
    std::vector<std::string> given;
    if (!flags.displacement.empty()) given.emplace_back("--displacement");
    session::refuse_for_spindle(file.model, given);
  }
  if (flags.data.empty()) return run_model(file, flags.json);
  const auto subject = io::make_subject(file.model);
  const record::Record data =
      session::open_data(messages(), flags.data, *subject, flags.reading.options(file));
  const fit::Check check = fit::check(*subject, data);
  std::vector<std::string> notes = file.notes;
  notes.insert(notes.end(), data.notes.begin(), data.notes.end());
  if (!check.problem.empty()) {
    warn({check.problem});
    notes.push_back(check.problem);
  }
  if (!check.runs_coincide_with.empty()) {
    notes.push_back(fmt::format(
        "each run has its own {0}: what depends on it cannot be told from a rig that was set up "
        "anew; before measuring more, plan two runs or more for each level, or all levels within "
        "each run",
        check.runs_coincide_with));
    warn({notes.back()});
  }
  if (flags.json) {
    put_document(io::check_json(file.model.name, check, file.defaults, notes));
  } else {
    print(check, data);
    fmt::print("\n");
    print_defaults(file.source, file.defaults);
  }
  if (!flags.output.empty()) {
    io::write_text(flags.output, io::record_text(data), if_exists);
    say(fmt::format("{} written, {} rows", flags.output, data.rows()));
  }
  return done;
}

}  // namespace

Run setup_check(CLI::App& command) {
  auto flags = std::make_shared<CheckFlags>();
  command.add_option("MODEL", flags->model, "model file (TOML)")->required()->type_name("");
  command.add_option("DATA", flags->data, "measurements (CSV); without them the model alone")
      ->type_name("");
  declare_displacement(command, flags->displacement);
  declare(command, flags->reading);
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  command
      .add_option("-o,--output", flags->output,
                  "the rows as they were read, in our columns (CSV);\nof a coast-down its torques")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  command
      .add_flag("--suggest-columns", flags->suggest,
                "only propose which of their columns is which of ours (TOML)")
      ->excludes("--json");
  command.footer(
      "Example:\n  raceway check my.toml\n  raceway check my.toml rig.csv\n"
      "  raceway check my.toml export.csv --suggest-columns > map.toml\n"
      "  raceway check my.toml export.csv --columns map.toml");
  return [flags] {
    if (flags->suggest) return suggest(flags->model, flags->data);
    return run(*flags);
  };
}

}  // namespace raceway::cli
