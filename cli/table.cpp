#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/axis_flag.h"
#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/csv_style.h"
#include "cli/merge.h"
#include "cli/messages.h"
#include "cli/progress.h"
#include "cli/report_flag.h"
#include "cli/shared_flags.h"
#include "cli/stribeck_text.h"
#include "cli/table_memory.h"
#include "files/subject.h"
#include "report/report.h"
#include "report/table_plot.h"
#include "session/bands.h"
#include "session/open_input.h"
#include "session/reading.h"
#include "session/table_question.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

struct TableFlags {
  std::string model, output;
  AxisFlags axes;
  std::string data, slab, plot;
  std::vector<std::string> merge;
  CsvStyle csv;
  bool json = false, force = false;
  ReportFlag report;
  BandFlag band;
  session::Reading reading;
};

/// "2/4" is the second of four.
friction::TableSlab slab(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const auto whole = [&](std::string_view part) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    return error == std::errc() && end == part.data() + part.size() ? value : 0;
  };
  const std::string_view all = text;
  const std::size_t index = slash == text.npos ? 0 : whole(all.substr(0, slash));
  const std::size_t count = slash == text.npos ? 0 : whole(all.substr(slash + 1));
  constexpr std::size_t most = 1000000;
  if (index == 0 || index > count || count > most)
    throw text::InputError("--slab: " + text::quoted(text) +
                               ": write i/N with i from 1 to N, N up to a million, as 2/4",
                           {.key = "--slab"});
  return {.index = index - 1, .count = count};
}

int run(const TableFlags& flags) {
  const auto if_exists = flags.force ? text::IfExists::replace : text::IfExists::refuse;
  if (!flags.merge.empty()) {
    merge_slabs(flags.merge, flags.output, flags.csv, if_exists);
    return done;
  }
  const std::string& format = flags.csv.format;
  if (format != "csv" && flags.output.empty())
    throw text::InputError("raceway table: --format needs a file: --output is missing",
                           {.key = "--format"});
  if (format != "csv" && !flags.slab.empty())
    throw text::InputError("raceway table: a slab is to be merged, which takes --format csv alone",
                           {.key = "--slab"});
  refuse_two_on_stdout("table", flags.json, flags.output);
  const friction::TableSlab part = slab(flags.slab);
  if (!flags.slab.empty() && (flags.output.empty() || flags.json))
    throw text::InputError(
        "raceway table: a slab is for a file to be merged: --slab needs --output",
        {.key = "--slab"});
  flags.csv.require_writable(flags.output, if_exists);
  if (!flags.plot.empty()) {
    text::require_name_of(flags.plot, text::Written::picture);
    text::require_writable(flags.plot, if_exists);
  }
  if (!flags.data.empty() && flags.report.path.empty())
    throw text::InputError("raceway table: --data is drawn in a report: --report is missing",
                           {.key = "--report"});
  if (flags.data.empty() && (!flags.reading.columns.empty() || flags.reading.drop_nan))
    throw text::InputError(
        "raceway table: --columns and --drop-nan are of measurements: --data is missing",
        {.key = "--data"});
  flags.report.check(flags.force);
  const files::ModelFile file =
      session::open_model(messages(), flags.model, session::Accepts::rig_or_shaft);
  const model::Model& model = file.model;
  session::warn_of_ignored_data(messages(), file);
  std::optional<record::Record> measured;
  if (!flags.data.empty())
    measured = session::open_data(messages(), flags.data, *files::make_subject(model),
                                  flags.reading.options(file));
  const session::TableQuestion question{.axes = flags.axes.asked(),
                                        .slab = part,
                                        .band = flags.band.of(file),
                                        .wording = session::Wording::flags};
  session::TablePlan plan = session::plan_table(messages(), file, question);
  require_memory(plan.axes, part, plan.columns.size(),
                 flags.json             ? TableForm::json
                 : flags.output.empty() ? TableForm::text
                                        : TableForm::file);
  const std::size_t points = part.points(plan.axes.size());
  std::optional<Progress> bar;
  if (shows_progress() && points >= 20000) bar.emplace();
  // Of the time a file takes, as measured: solving, making the text, and the disk.
  const double solved = flags.output.empty() ? 1.0 : 0.8, made = flags.output.empty() ? 1.0 : 0.95;
  const auto progress = [&](double from, double to, std::string_view step) {
    return !bar ? std::function<void(double)>() : [&bar, from, to, step](double share) {
      bar->show(std::min(from + share * (to - from), 0.999), step);
    };
  };
  const session::TableAnswer answer =
      session::make_table(file, question, std::move(plan), progress(0.0, solved, {}));
  const friction::StribeckTable& table = answer.table;
  if (!flags.output.empty()) {
    const std::string text =
        answer.text(file, format == "excel" ? "csv" : format, progress(solved, made, "writing"));
    if (bar) bar->show(1.0);
    bar.reset();
    flags.csv.put(flags.output, text, if_exists, fmt::format(", {} points", points));
  }
  if (bar) bar->show(1.0);
  bar.reset();
  if (!flags.plot.empty()) {
    text::write_text(flags.plot, report::table_svg(table, model.name), if_exists);
    say(flags.plot + " written");
  }
  if (flags.json) {
    put_document(answer.json(model));
  } else if (flags.output.empty()) {
    print_table(model, table);
    if (answer.band) fmt::print("\n+-: {}\n", session::band_statement(*answer.band));
  }
  if (answer.band && (flags.json || !flags.output.empty()))
    tell({"band: " + session::band_statement(*answer.band)});
  flags.report.write(
      [&] {
        return report::table_report(file.source, model, table,
                                    session::states_to_draw(model, table.axes),
                                    measured ? &*measured : nullptr,
                                    {session::of_page(file, model)}, texts(answer.warnings()));
      },
      flags.force);
  tell(answer.notes(model));
  tell(answer.warnings());
  const session::TableFailures failed = session::failures(model, table);
  warn(failed.lines);
  return failed.without_torque ? not_converged : done;
}

}  // namespace

Run setup_table(CLI::App& command) {
  auto flags = std::make_shared<TableFlags>();
  command.add_option("MODEL", flags->model, "model file (TOML)")->required()->type_name("");
  flags->axes.declare(command,
                      "[rpm]; like all axes as 100,300,900 or as from:to:step, 0:12000:250");
  command.add_option("-o,--output", flags->output, "CSV file to write; - for stdout")
      ->type_name("FILE");
  command
      .add_option("--slab", flags->slab, "only the i-th of N parts of the table, for table --merge")
      ->type_name("i/N");
  flags->csv.declare(command, {"modelica"}, "modelica (CombiTable, SI), ");
  command.add_option("--plot", flags->plot, "torque over speed as a picture (SVG)")
      ->type_name("FILE");
  command.add_flag("--force", flags->force, "replace the file if it exists");
  flags->band.declare(command);
  command.add_flag("--json", flags->json, "one JSON document instead of text");
  flags->report.declare(command);
  command
      .add_option("--data", flags->data, "measurements (CSV) to draw into the curves of the report")
      ->type_name("FILE");
  declare(command, flags->reading);
  const std::vector<CLI::Option*> declared = command.get_options();
  CLI::Option* const merge =
      command
          .add_option("--merge", flags->merge,
                      "instead of MODEL: join these files, which --slab wrote, in any order")
          ->each([declared](const std::string&) {
            for (CLI::Option* const option : declared) option->required(false);
          })
          ->type_name("FILE");
  constexpr std::array<std::string_view, 6> of_a_file{"output",    "force",        "format",
                                                      "separator", "decimal-mark", "help"};
  for (CLI::Option* const option : declared)
    if (std::find(of_a_file.begin(), of_a_file.end(), option->get_single_name()) == of_a_file.end())
      merge->excludes(option);
  command.footer(
      "Example:\n  raceway table my.toml --speed 0:12000:250 --axial-load 100,300,900 "
      "-o stribeck.csv\n  raceway table --merge slab-*.csv -o stribeck.csv");
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
