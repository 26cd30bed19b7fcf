#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/axis_flag.h"
#include "cli/band_flag.h"
#include "cli/commands.h"
#include "cli/merge.h"
#include "cli/output_flags.h"
#include "cli/progress.h"
#include "cli/stribeck_text.h"
#include "cli/table_memory.h"
#include "files/subject.h"
#include "report/report.h"
#include "report/table_plot.h"
#include "session/bands.h"
#include "session/open_input.h"
#include "session/reading.h"
#include "session/table_question.h"
#include "text/error.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

struct TableFlags : ResultFlags {
  std::string model, data, slab, plot;
  AxisFlags axes;
  std::vector<std::string> merge;
  BandFlag band;
  session::Reading reading;
};

void check_flags(const TableFlags& f) {
  const auto fail = [](const char* flag, const std::string& why) {
    throw text::InputError("raceway table: " + why, {.key = flag});
  };
  if (f.csv.format != "csv" && f.output.empty()) fail("--format", "--format needs --output FILE");
  if (f.csv.format != "csv" && !f.slab.empty())
    fail("--slab", "--slab needs --format csv, because --merge reads only this format");
  if (!f.slab.empty() && (f.output.empty() || f.json))
    fail("--slab",
         "--slab needs --output FILE and is not possible with --json, because --slab writes a file "
         "for --merge");
  f.check_results("table");
  if (!f.plot.empty()) {
    text::require_name_of(f.plot, text::Written::picture);
    text::require_writable(f.plot, f.if_exists());
  }
  if (!f.data.empty() && f.report.path.empty())
    fail("--report", "--data needs --report FILE, because the data are drawn in the report");
  if (f.data.empty() && (!f.reading.columns.empty() || f.reading.drop_nan))
    fail("--data", "--columns and --drop-nan need --data");
}

/// Shows the share of the work that is done, where the table is large and a person looks on.
class TableProgress {
 public:
  TableProgress(std::size_t points, bool to_file)
      : solved_(to_file ? 0.8 : 1.0), written_(to_file ? 0.95 : 1.0) {
    if (shows_progress() && points >= 20000) bar_.emplace();
  }
  [[nodiscard]] std::function<void(double)> solving() { return part(0.0, solved_, {}); }
  [[nodiscard]] std::function<void(double)> writing() { return part(solved_, written_, "writing"); }
  void end() {
    if (bar_) bar_->show(1.0);
    bar_.reset();
  }

 private:
  std::function<void(double)> part(double from, double to, std::string_view step) {
    if (!bar_) return {};
    return [this, from, to, step](double share) {
      bar_->show(std::min(from + share * (to - from), 0.999), step);
    };
  }

  std::optional<Progress> bar_;
  // Shares of the time that a file takes, as measured: solving, making the text, and the disk.
  double solved_, written_;
};

/// The table in the files asked for and on the screen.
void put(const TableFlags& f, const files::ModelFile& file, const session::TableAnswer& answer,
         std::size_t points, TableProgress& progress) {
  if (!f.output.empty()) {
    const std::string text =
        answer.text(file, f.csv.format == "excel" ? "csv" : f.csv.format, progress.writing());
    progress.end();
    f.csv.put(f.output, text, f.if_exists(), fmt::format(", {} points", points));
  }
  progress.end();
  const model::Model& model = file.model;
  if (!f.plot.empty()) {
    text::write_text(f.plot, report::table_svg(answer.table, model.name), f.if_exists());
    say(f.plot + " written");
  }
  const std::string band = answer.band ? session::band_statement(*answer.band) : std::string();
  if (f.json) {
    put_document(answer.json(model));
  } else if (f.output.empty()) {
    print_table(model, answer.table);
    if (!band.empty()) fmt::print("\n+-: {}\n", band);
  }
  if (!band.empty() && (f.json || !f.output.empty())) tell({"band: " + band});
}

int run(const TableFlags& flags) {
  if (!flags.merge.empty()) {
    merge_slabs(flags.merge, flags.output, flags.csv, flags.if_exists());
    return done;
  }
  const friction::TableSlab part = slab_of(flags.slab);
  check_flags(flags);
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
  TableProgress progress(points, !flags.output.empty());
  const session::TableAnswer answer =
      session::make_table(file, question, std::move(plan), progress.solving());
  put(flags, file, answer, points, progress);
  flags.put_page([&] {
    return report::table_report(
        file.source, model, answer.table, session::states_to_draw(model, answer.table.axes),
        measured ? &*measured : nullptr, {session::of_page(file, model)}, texts(answer.warnings()));
  });
  tell(answer.notes(model));
  tell(answer.warnings());
  const session::TableFailures failed = session::failures(model, answer.table);
  warn(failed.lines);
  return failed.without_torque ? not_converged : done;
}

}  // namespace

Run setup_table(CLI::App& command) {
  auto flags = std::make_shared<TableFlags>();
  declare_model(command, flags->model);
  flags->axes.declare(command,
                      "speeds [rpm]; write each axis as a list such as 100,300,900 or as a range "
                      "from:to:step such as 0:12000:250");
  flags->declare_output(command, "CSV file to write; - for stdout");
  command
      .add_option("--slab", flags->slab,
                  "calculate only part i of N of the table, for table --merge")
      ->type_name("i/N");
  command.add_option("--plot", flags->plot, "SVG picture to write, torque over speed")
      ->type_name("FILE");
  flags->band.declare(command);
  flags->declare_results(command, {"modelica"}, "modelica (CombiTable, SI), ");
  command.add_option("--data", flags->data, "measurements (CSV) to draw in the report")
      ->type_name("FILE");
  declare(command, flags->reading);
  const std::vector<CLI::Option*> declared = command.get_options();
  CLI::Option* const merge =
      command
          .add_option(
              "--merge", flags->merge,
              "files written by --slab, in any order; the command joins them and needs no MODEL")
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
