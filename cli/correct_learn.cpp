#include "cli/correct_learn.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/messages.h"
#include "cli/text_table.h"
#include "correction/learning.h"
#include "io/csv.h"
#include "io/error.h"
#include "io/learning_results.h"
#include "io/number_text.h"
#include "io/units.h"
#include "session/correction_input.h"

namespace raceway::cli {
namespace {

constexpr double an_hour = 3600.0;

/// "4h", "30 min" in seconds.
double duration(const std::string& text, const std::string& flag) {
  const auto refuse = [&](const std::string& why) {
    throw io::InputError(fmt::format("{} {}: {}", flag, io::quoted(text), why), {.key = flag});
  };
  double value = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  const io::Unit* const unit =
      error == std::errc() ? io::find_unit({end, last}, io::Dimension::time) : nullptr;
  if (!unit) refuse("write a number and its unit (s, min, h, d), as 4h");
  const double seconds = unit->to_SI(value);
  if (!(seconds > 0.0) || !(seconds <= 1e9)) refuse("must be above 0, and 1e9 s at most");
  return seconds;
}

correction::Learning learnt(const correction::Model& model, const record::Record& record,
                            const LearnFlags& flags, const std::string& source) {
  correction::LearningOptions options;
  if (!flags.every.empty()) options.every = duration(flags.every, "--every");
  if (!flags.forget.empty()) options.forgetting = duration(flags.forget, "--forget");
  try {
    return correction::learn(model, record, options);
  } catch (const std::invalid_argument& e) {
    throw io::InputError(fmt::format("{} with {}: {}", record.source, source, e.what()),
                         {.file = record.source});
  }
}

/// What was assumed, where the model does not say.
std::vector<std::string> notes_on(const correction::Model& model) {
  std::vector<std::string> notes;
  if (std::isnan(model.tolerance))
    notes.push_back(
        fmt::format("{}: no tolerance_um in the model: a misfit of {:g} um is assumed, "
                    "and no reading is due",
                    model.displacement->name, correction::usual_misfit / um));
  if (std::isnan(model.measured_std))
    notes.push_back(
        fmt::format("{}: no measurement_std_um in the model: readings are taken to "
                    "scatter by {:g} um",
                    model.displacement->name, correction::usual_reading_std / um));
  if (model.range.empty())
    notes.push_back(
        fmt::format("{}: no [correction.range] in the model: lags that it lacks are "
                    "not sought",
                    model.displacement->name));
  return notes;
}

std::vector<std::string> warnings_on(const io::Learnt& one, const record::Record& record) {
  std::vector<std::string> list;
  const auto place = [&](std::size_t row) {
    return fmt::format("{}: {} ({:.4g} h)", one.displacement->name, record.place(row),
                       record.value(record::time, row) / an_hour);
  };
  for (const correction::OfferedReading& r : one.learning.readings)
    if (!r.learnt)
      list.push_back(
          fmt::format("{}: {:.4g} um read where {:.4g} +- {:.2g} was expected: refused, "
                      "not learnt",
                      place(r.row), r.reading / um, r.predicted / um, r.std / um));
  for (const correction::IdentificationDue& d : one.learning.due)
    list.push_back(fmt::format("{}: a new identification is due: {}", place(d.row), d.reason));
  return list;
}

std::string next_reading(const correction::Learning& l) {
  if (std::isnan(l.next_reading)) return "-";
  if (l.next_reading == 0.0) return "now";
  if (std::isinf(l.next_reading)) return "never";
  return fmt::format("{:.1f} h", l.next_reading / an_hour);
}

void print_errors(const std::vector<io::Learnt>& list) {
  TextTable table({{"displacement", "", true},
                   {"learnt", ""},
                   {"judged by", ""},
                   {"first zero", "um"},
                   {"last zero", "um"},
                   {"learning", "um"},
                   {"due in", ""}});
  for (const io::Learnt& one : list) {
    const correction::Learning& l = one.learning;
    const auto count =
        std::count_if(l.readings.begin(), l.readings.end(), [](const auto& r) { return r.learnt; });
    table.add({std::string(one.displacement->name), fmt::format("{}", count),
               fmt::format("{}", l.error.readings), number(l.error.first / um, 3),
               number(l.error.zeroed / um, 3), number(l.error.learnt / um, 3), next_reading(l)});
  }
  fmt::print("{}", table.text(terminal_width()));
  fmt::print(
      "\nRMS of the readings that nothing was learnt from: of the model with the zero of the "
      "first\n"
      "reading, with that of the last one, and as it learns. Due: the next reading, for the "
      "tolerance\n");
}

/// Gains, and those lags that stand out.
void print_gains(const io::Learnt& one, bool several) {
  TextTable table({{"gain of", "", true}, {"learnt", ""}, {"std", ""}, {"", "", true}});
  for (const correction::LearntGain& g : one.learning.gains) {
    const double unit = g.is_lag ? um : 0.01;
    if (g.is_lag && !(std::abs(g.value) > g.std)) continue;
    table.add({g.name, fmt::format("{:+.1f}", g.value / unit), fmt::format("{:.1f}", g.std / unit),
               fmt::format("{}{}", g.is_lag ? "um" : "%", g.at_bound ? ", at its bound" : "")});
  }
  fmt::print("\n{}{}", several ? fmt::format("{}\n", one.displacement->name) : "",
             table.text(terminal_width()));
}

void save(const io::CorrectionFile& file, const std::vector<io::Learnt>& list,
          const std::string& path, io::IfExists if_exists) {
  std::vector<correction::Model> models;
  for (const io::Learnt& one : list) {
    models.push_back(one.learning.model);
    models.back().range.clear();  // what the file has stays
  }
  io::write_text(path, io::with_corrections(file, models), if_exists);
  say(path + " written");
}

}  // namespace

void LearnFlags::declare(CLI::App& command) {
  command.add_flag("--learn", learn,
                   "take readings as they come: zero, states and gains are learnt,\n"
                   "a row is predicted from readings before it alone");
  command
      .add_option("--every", every,
                  "with --learn: at least between two readings that are learnt, as 4h;\n"
                  "the others judge; default: all are learnt")
      ->type_name("TIME");
  command
      .add_option("--forget", forget,
                  "with --learn: time in which gains return to the model's; default 7d")
      ->type_name("TIME");
  command.add_option("--save", save, "with --learn: file for MODEL with zero and gains at the end")
      ->type_name("MODEL2");
}

void LearnFlags::check(io::IfExists if_exists) const {
  const auto needs = [&](const std::string& value, const std::string& flag) {
    if (!value.empty() && !learn)
      throw io::InputError(flag + ": belongs to --learn", {.key = flag});
  };
  needs(every, "--every");
  needs(forget, "--forget");
  needs(save, "--save");
  if (!every.empty()) (void)duration(every, "--every");
  if (!forget.empty()) (void)duration(forget, "--forget");
  if (save == "-")
    throw io::InputError("--save -: stdout shows the numbers; name a file", {.key = "--save"});
  if (!save.empty()) io::require_writable(save, if_exists);
}

void run_learning(const io::CorrectionFile& file, const record::Record& record,
                  const LearnFlags& flags, const CorrectOutput& output) {
  std::vector<io::Learnt> list;
  std::vector<std::string> messages, notes;
  for (const correction::Model& model : file.models) {
    list.push_back({model.displacement, learnt(model, record, flags, file.source)});
    for (std::string& text : warnings_on(list.back(), record)) messages.push_back(std::move(text));
    for (std::string& text : session::range_notes(model, record))
      messages.push_back(std::move(text));
    for (std::string& text : notes_on(model)) notes.push_back(std::move(text));
    if (list.back().learning.error.readings == 0)
      notes.push_back(
          fmt::format("{}: every reading was taken to learn from; --every leaves some to "
                      "judge by",
                      model.displacement->name));
  }
  tell(notes);
  if (!output.csv.empty()) {
    const std::string csv = io::learnt_text(record, list);
    if (output.csv == "-") {
      fmt::print("{}", csv);
    } else {
      io::write_text(output.csv, csv, output.if_exists);
      say(fmt::format("{} written, {} rows", output.csv, record.rows()));
    }
  }
  if (!flags.save.empty()) save(file, list, flags.save, output.if_exists);
  if (output.json) {
    messages.insert(messages.end(), notes.begin(), notes.end());
    put_document(io::learnt_json(file.source, record, list, messages));
  } else if (output.csv != "-") {
    fmt::print(
        "{}: {} rows over {:.4g} h\n\n", record.source, record.rows(),
        (record.values(record::time).back() - record.values(record::time).front()) / an_hour);
    print_errors(list);
    for (const io::Learnt& one : list) print_gains(one, list.size() > 1);
  }
  warn(messages);
}

}  // namespace raceway::cli
