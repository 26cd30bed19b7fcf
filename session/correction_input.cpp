#include "session/correction_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correction/baseline.h"
#include "correction/record_check.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "files/correction_join.h"
#include "files/series_doubts.h"
#include "files/series_file.h"
#include "session/isolated.h"
#include "session/open_input.h"
#include "text/error.h"
#include "text/input_file.h"
#include "text/names.h"
#include "text/number_text.h"

namespace raceway::session {

using text::number;

files::CorrectionFile open_corrections(Messages& messages, const Source& source,
                                       Defaults defaults) {
  const std::string& path = source.name;
  files::CorrectionFile file = source.text
                                   ? files::parse_correction(*source.text, path, source.files)
                                   : files::read_correction(path);
  for (const files::NamedFile& named : file.files) messages.reads(named.path);
  const std::size_t count = defaults == Defaults::count ? file.defaults.size() : 0;
  if (count > 0)
    messages.say(
        record::note::defaults(fmt::format("{} assumption{}; raceway check {} lists {}", count,
                                           count == 1 ? "" : "s", path, count == 1 ? "it" : "them"),
                               {.file = path}));
  say_of(messages, file.source, file.notes);
  return file;
}

files::CorrectionFile join(Messages& messages, const std::vector<Source>& parts,
                           const std::string& path) {
  std::vector<files::CorrectionFile> files;
  for (const Source& part : parts)
    files.push_back(open_corrections(messages, part, Defaults::keep));
  files::JoinedCorrection joined = files::join_corrections(files, path);
  messages.say(joined.notes);
  return files::parse_correction(std::move(joined.text), path, std::move(joined.files));
}

record::Record open_series(Messages& messages, const Source& given,
                           const std::vector<correction::Model>& models,
                           const files::ReadOptions& options, const Period& period,
                           bool one_by_one) {
  const std::string& path = given.name;
  if (path.ends_with(".toml"))
    throw text::InputError(
        path + ": this is a model file; a record over time (CSV) is expected here", {.file = path});
  std::vector<const record::Channel*> wanted, needed;
  for (const correction::Model& m : models) {
    wanted.push_back(m.displacement);
    for (const record::Channel* c : correction::inputs_of(m))
      if (std::find(needed.begin(), needed.end(), c) == needed.end()) needed.push_back(c);
  }
  const Source data = files::repeatable(given);
  record::Record record = files::read_series(data, wanted, needed, options);
  const std::vector<record::Note> doubts =
      files::asked_about(files::series_doubts(record, models), data, files::over_time(options));
  period.apply(record, wanted);
  append(record.notes, doubts);
  for (record::Note& one : record.notes)
    if (one.place.file.empty()) one.place.file = path;
  messages.say(record.notes);
  if (!one_by_one) leave_out_isolated(messages, record, wanted);
  return record;
}

SeriesQuestion ask_series(Messages& messages, const Source& model, const Source& data,
                          const Reading& reading, Defaults defaults) {
  SeriesQuestion asked{.file = open_corrections(messages, model, defaults)};
  asked.data = open_series(messages, reading.sources({data}).front(), asked.file.models,
                           reading.options(asked.file.columns), reading.period, reading.one_by_one);
  return asked;
}

void require_readings(const correction::Model& model, const record::Record& record) {
  if (!record.has(*model.displacement))
    throw text::InputError(
        fmt::format("{}: has no column {}", record.source, model.displacement->name),
        {.file = record.source, .key = std::string(model.displacement->name)});
}

std::vector<std::string> fitted_start(const correction::Model& model) {
  if (model.initial_state != correction::InitialState::free) return {};
  return {
      fmt::format("{}: initial_state = \"free\": the state at the start is fitted to these "
                  "readings. A control has no readings, so its error can be larger",
                  model.displacement->name)};
}

void prepare_fit(Messages& messages, const correction::Model& model, const std::string& source,
                 record::Record& record) {
  if (const std::string beyond = correction::beyond_element(model, record); !beyond.empty())
    throw text::InputError(fmt::format("{} with {}: {}", record.source, source, beyond),
                           {.file = record.source});
  const std::vector<record::Note> faults = correction::check_record(model, record).of_its_inputs;
  messages.say(faults);
  append(record.notes, faults);
}

namespace {

std::string when(const record::Record& record, std::size_t row) {
  return fmt::format("{} ({:.4g} s)", record.place(row), record.value(record::time, row));
}

/// Largest distance of the input from its range, in widths of the range.
double excess(const correction::Beyond::Part& p) {
  if (p.together()) return -1.0;  // last
  return (p.farthest > p.upper ? p.farthest - p.upper : p.lower - p.farthest) / (p.upper - p.lower);
}

std::string note_of(const correction::Beyond::Part& p, const record::Record& record) {
  const std::string share =
      p.rows == record.rows() - p.first
          ? fmt::format("in all {} rows", p.rows)
          : fmt::format("in {} of the {} rows", p.rows, record.rows() - p.first);
  if (p.together())
    return fmt::format(
        "from {} on, {}, this combination of inputs lies outside the training data (distance "
        "{:.3g} in the first of these rows, {:.3g} at most; largest in training {:.3g}): treat the "
        "result as extrapolation",
        when(record, p.first), share, p.value, p.farthest, p.upper);
  const auto shown = [&](double v) { return number(p.column ? p.column->in_unit(v) : v, 5); };
  return fmt::format(
      "{}: from {} on, {}, the input is outside the training data of {} to {} {}: {} in the first "
      "of these rows, {} in the row farthest outside",
      p.column ? p.name : p.name + " power_W", when(record, p.first), share, shown(p.lower),
      shown(p.upper), p.column ? std::string(p.column->unit) : "W", shown(p.value),
      shown(p.farthest));
}

}  // namespace

std::vector<std::string> range_notes(const correction::Model& model,
                                     const correction::Series& series,
                                     const correction::Beyond& beyond) {
  const record::Record& record = series.record();
  std::vector<std::string> notes;
  if (!beyond.parts.empty() && correction::is_regression(model)) {
    const std::vector<double> share = correction::extrapolated(model, series, beyond);
    const auto most = std::max_element(share.begin(), share.end());
    notes.push_back(
        fmt::format("outside the training data a regression extrapolates linearly. The largest "
                    "extrapolated part of its prediction is {:.3g} {} in {}",
                    *most / um, correction::unit_of(model),
                    when(record, static_cast<std::size_t>(most - share.begin()))));
  }
  std::vector<const correction::Beyond::Part*> parts;
  for (const correction::Beyond::Part& p : beyond.parts) parts.push_back(&p);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto* a, const auto* b) { return excess(*a) > excess(*b); });
  for (const correction::Beyond::Part* p : parts) notes.push_back(note_of(*p, record));
  for (const correction::DrivenChannel& c : model.channels)
    if (const std::size_t rows = series.rows_beyond_table(c.input); rows > 0)
      notes.push_back(fmt::format(
          "channel {}: {:.1f} % of the rows lie outside the range of {}; for these rows, the "
          "program uses the value at the edge",
          c.name, 100.0 * static_cast<double>(rows) / static_cast<double>(record.rows()),
          c.input.table->file));
  return notes;
}

std::vector<std::string> range_notes(const correction::Model& model, const record::Record& record) {
  const correction::Series series(record);
  return range_notes(model, series, correction::beyond_range(model, series));
}

}  // namespace raceway::session
