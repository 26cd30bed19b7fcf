#include "cli/correct_learn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/identification_text.h"
#include "cli/messages.h"
#include "cli/text_table.h"
#include "correction/learning.h"
#include "results/learning_results.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

constexpr double an_hour = 3600.0;

std::string next_reading(const correction::Learning& l) {
  if (std::isnan(l.next_reading)) return "-";
  if (l.next_reading == 0.0) return "now";
  if (std::isinf(l.next_reading)) return "never";
  return fmt::format("{:.1f} h", l.next_reading / an_hour);
}

void print_errors(const std::vector<results::Learnt>& list) {
  const CommonUnit unit(list);
  TextTable table({{"displacement", "", true},
                   {"learnt", ""},
                   {"tested", ""},
                   {"first zero", unit.head()},
                   {"last zero", unit.head()},
                   {"learning", unit.head()},
                   {"due in", ""}});
  for (const results::Learnt& one : list) {
    const correction::Learning& l = one.learning;
    const auto count =
        std::count_if(l.readings.begin(), l.readings.end(), [](const auto& r) { return r.learnt; });
    table.add({std::string(one.displacement->name), fmt::format("{}", count),
               fmt::format("{}", l.error.readings), unit.text(one, l.error.first, 3),
               unit.text(one, l.error.zeroed, 3), unit.text(one, l.error.learnt, 3),
               next_reading(l)});
  }
  fmt::print("{}", table.text(terminal_width()));
  fmt::print(
      "\nRMS errors of three predictions at the readings that were not used for learning. first "
      "zero: model\nwithout learning; its zero is the first used reading of each run. last zero: "
      "model without\nlearning; its zero is the latest used reading. learning: model with "
      "learning. due in: time until\nthe next reading is needed\n");
}

/// Gains, and those lags that stand out.
void print_gains(const results::Learnt& one, bool several) {
  TextTable table({{"gain of", "", true}, {"learnt", ""}, {"std", ""}, {"", "", true}});
  for (const correction::LearntGain& g : one.learning.gains) {
    const double unit = g.is_lag ? um : 0.01;
    if (g.is_lag && !(std::abs(g.value) > g.std)) continue;
    table.add({g.name, fmt::format("{:+.1f}", g.value / unit), fmt::format("{:.1f}", g.std / unit),
               fmt::format("{}{}", g.is_lag ? one.displacement->unit : "%",
                           g.at_bound ? ", at its bound" : "")});
  }
  fmt::print("\n{}{}", several ? fmt::format("{}\n", one.displacement->name) : "",
             table.text(terminal_width()));
}

}  // namespace

void LearnFlags::declare(CLI::App& command) {
  command.add_flag(
      "--learn", learn,
      "update the zero, the states of the lags and the gains with each reading, in the "
      "order of time; each prediction uses only earlier readings");
  command
      .add_option("--every", choices.every,
                  "with --learn: shortest time between two readings for learning, such as 4h; the "
                  "other readings test the prediction; default: all readings are used for learning")
      ->type_name("TIME");
  command
      .add_option("--forget", choices.forget,
                  "with --learn: time constant with which the gains return to the values of the "
                  "model; default 7d")
      ->type_name("TIME");
  command
      .add_option("--save", save,
                  "with --learn: file to write, MODEL with the learnt zero and gains at the end of "
                  "the record")
      ->type_name("MODEL2");
}

void LearnFlags::check(text::IfExists if_exists) const {
  const auto needs = [&](const std::string& value, const std::string& flag) {
    if (!value.empty() && !learn)
      throw text::InputError(flag + ": only possible with --learn", {.key = flag});
  };
  needs(choices.every, "--every");
  needs(choices.forget, "--forget");
  needs(save, "--save");
  choices.check();
  if (save == "-")
    throw text::InputError("--save -: not possible, because stdout shows the results; name a file",
                           {.key = "--save"});
  if (!save.empty()) text::require_writable(save, if_exists);
}

void run_learning(session::SeriesQuestion asked, const LearnFlags& flags,
                  const ResultFlags& results) {
  const session::LearningRun run = session::learn(std::move(asked), flags.choices);
  const record::Record& record = run.asked.data;
  tell(run.notes);
  results.put_table([&] { return run.csv(); }, fmt::format(", {} rows", record.rows()));
  if (!flags.save.empty()) {
    text::write_text(flags.save,
                     files::with_names_from(run.text(), run.asked.file.files, flags.save),
                     results.if_exists());
    say(flags.save + " written");
  }
  if (results.json) {
    put_document(run.json());
  } else if (results.output != "-") {
    fmt::print(
        "{}: {} rows over {:.4g} h\n\n", record.source, record.rows(),
        (record.values(record::time).back() - record.values(record::time).front()) / an_hour);
    print_errors(run.learnt);
    for (const results::Learnt& one : run.learnt) print_gains(one, run.learnt.size() > 1);
  }
  tell(run.warnings);
}

}  // namespace raceway::cli
