#include "session/open_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/data_file.h"
#include "files/doubts.h"
#include "files/series_doubts.h"
#include "files/spindle_record.h"
#include "files/subject.h"
#include "fit/isolated_readings.h"
#include "model/ignored_data.h"
#include "model/prediction.h"
#include "model/row.h"
#include "model/steps.h"
#include "session/isolated.h"
#include "session/judged.h"
#include "shaft/displacement_rows.h"
#include "text/error.h"
#include "text/input_file.h"

namespace raceway::session {

void refuse_data(const std::string& model, const record::Record& data,
                 const std::invalid_argument& error) {
  std::string message = error.what();
  if (const std::string place = data.source + ": "; message.starts_with(place))
    message.erase(0, place.size());
  throw text::InputError(fmt::format("{} with {}: {}", data.source, model, message),
                         {.file = data.source});
}

void say_of(Messages& messages, const std::string& source, std::vector<record::Note> notes) {
  for (record::Note& one : notes) {
    one.text.insert(0, source + ": ");
    messages.say(one);
  }
}

files::ModelFile open_model(Messages& messages, const Source& source, Accepts accepts,
                            Defaults defaults) {
  const std::string& path = source.name;
  files::ModelFile file = [&] {
    try {
      return source.text ? files::parse_model(*source.text, path, source.files)
                         : files::read_model(path);
    } catch (const text::InputError& e) {
      if (!path.ends_with(".csv")) throw;
      throw text::InputError(
          std::string(e.what()) + "\n" + path +
              ": this is a file of measurements; a model (TOML) is expected here",
          e.place);
    }
  }();
  if (file.model.shaft && accepts == Accepts::rig)
    throw text::InputError(
        path +
            ": the model has an [arrangement], but this command needs a single "
            "bearing on a rig. For a shaft, use the commands displacement, solve, table, "
            "sensitivity, check, compare, diagnose, add, or calibrate with data",
        {.file = path, .key = "arrangement"});
  if (accepts == Accepts::shaft) require_shaft(file);
  for (const files::NamedFile& named : file.files) messages.reads(named.path);
  const std::size_t count = defaults == Defaults::count ? file.defaults.size() : 0;
  if (count > 0)
    messages.say(record::note::defaults(
        fmt::format("{} assumption{}; raceway check {} lists {}", count, count == 1 ? "" : "s",
                    path == "-" ? "MODEL" : path, count == 1 ? "it" : "them"),
        {.file = path}));
  say_of(messages, file.source, file.notes);
  say_of(messages, file.source, said_of(judge_mounted(file)));
  say_of(messages, file.source, fit_notes(file.model));
  return file;
}

void require_shaft(const files::ModelFile& file) {
  if (!file.model.shaft)
    throw text::InputError(file.source +
                               ": the model has no [arrangement]; the shaft position needs this "
                               "table with layout, front, rear and preload_N",
                           {.file = file.source, .key = "arrangement"});
}

void warn_of_ignored_data(Messages& messages, const files::ModelFile& file) {
  const std::vector<std::string> ignored = model::ignored_by_friction(file.model, file.written);
  if (ignored.empty()) return;
  const friction::FrictionLaw law = file.model.law;
  const std::vector<std::string> taken = model::taken_in(friction::FrictionLaw::skf, ignored);
  const bool skf = !taken.empty() && law != friction::FrictionLaw::skf;
  messages.say(record::note::ignored(
      fmt::format(
          "{}: the friction torque by {} does not depend on {}{}; {}law = \"contact\" uses all "
          "these quantities (docs/laws.md)",
          file.source, friction::name(law), fmt::join(ignored, ", "),
          model::needs_equilibrium(file.model) ? "" : " and running contact angles",
          skf ? fmt::format("law = \"skf\" uses {}, and ", fmt::join(taken, ", ")) : std::string()),
      {.file = file.source}));
}

report::ModelOfPage of_page(const files::ModelFile& file, const model::Model& used) {
  return {.file = file.source, .model = used, .defaults = file.defaults};
}

namespace {

/// Each of `notes` said, and into the notes of the record for who reads its results as JSON.
/// `from`: the file, where it is one of several.
void put(Messages& messages, record::Record& data, std::vector<record::Note> notes,
         const std::string& from) {
  for (record::Note& one : notes) {
    if (one.place.file.empty()) one.place.file = data.source;
    if (!from.empty()) one.text.insert(0, from + ": ");
  }
  messages.say(notes);
  append(data.notes, std::move(notes));
}

/// Says how far the error band of a friction table reaches on the rows of a rig.
std::vector<record::Note> notes_on_table(const model::Model& model, const record::Record& data) {
  if (model.law != friction::FrictionLaw::table || model.shaft || !model.table->has_band())
    return {};
  double band = 0.0, torque = 0.0, rows = 0.0;
  for (const model::Row& row : model::rows_of(data)) {
    const friction::BearingState<> state = model::bearing_state(model, row.point, nullptr);
    const double scale = model.law_values.front() * rig_torque(model.rig, 1.0);
    const double half_width = scale * model.table->half_width(state);
    if (!std::isfinite(half_width)) continue;
    band += half_width * half_width;
    torque += std::pow(scale * model.table->moment(state), 2.0);
    rows += 1.0;
  }
  if (rows == 0.0) return {};
  return {record::note::band(fmt::format(
      "the friction table {} has a 95 % band of +-{:.3g} N mm (RMS over these rows; {:.2g} % of "
      "the torque from the table): an error within this band can come from the table",
      model.table->file, std::sqrt(band / rows) / N_mm, 100.0 * std::sqrt(band / torque)))};
}

record::Record open_one(Messages& messages, const Source& given, const model::ModelSubject& subject,
                        const files::ReadOptions& options, bool of_several) {
  const std::string& path = given.name;
  if (path.ends_with(".toml"))
    throw text::InputError(path + ": this is a model file; measurements (CSV) are expected here",
                           {.file = path});
  const Source source = files::repeatable(given);
  const std::string from = of_several ? path : std::string();
  if (const auto& spindle = subject.model().spindle) {
    record::Record data = files::read_spindle_record(source, *spindle, options);
    const std::vector<record::Note> doubts =
        files::asked_about(files::series_doubts(data, subject), source, files::of_spindle(options));
    put(messages, data, std::exchange(data.notes, {}), from);
    put(messages, data, doubts, from);
    require_possible(subject.model(), data);
    put(messages, data, said_of(judge(subject.model(), data)), from);
    put(messages, data, states_not_counted(subject.model()), from);
    const auto read = std::find_if(
        data.columns.begin(), data.columns.end(),
        [](const record::Column& c) { return c.channel->role == record::Role::measured; });
    if (read != data.columns.end()) leave_out_isolated(messages, data, {read->channel});
    return data;
  }
  if (!source.beside.empty())
    throw text::InputError(path +
                               ": the rows of a rig are separate states without a common clock; "
                               "--beside is only for records over time",
                           {.file = path, .key = "--beside"});
  record::Record data = files::read_record(source, subject, options);
  fit::PossibleRows possible = fit::without_impossible_rows(data);
  if (!possible.statements.empty()) {
    data = std::move(possible.record);
    append(data.notes,
           notes_of(record::note::left_out, std::move(possible.statements), {.file = data.source}));
  }
  if (std::string note = shaft::note_on_standstill(data); !note.empty())
    data.notes.push_back(record::note::read_as(std::move(note)));
  put(messages, data, std::exchange(data.notes, {}), from);
  put(messages, data,
      files::asked_about(files::doubts(*files::make_subject(subject.model(), data), data), source,
                         options),
      from);
  require_possible(subject.model(), data);
  put(messages, data, said_of(judge(subject.model(), data)), from);
  put(messages, data, notes_on_table(subject.model(), data), from);
  return data;
}

}  // namespace

record::Record open_data(Messages& messages, const Source& data, const model::ModelSubject& subject,
                         const files::ReadOptions& options) {
  return open_one(messages, data, subject, options, false);
}

void tell_of_scale(const record::Record& data, std::vector<record::Note>& messages) {
  if (data.up_to_a_factor)
    messages.push_back(record::note::limits(
        "the inertia is unknown, so all torques, f0, z and effect sizes in N mm have an unknown "
        "common factor; the result depends on the shape of the curve only",
        {.key = "inertia_kgm2"}));
}

record::Record open_records(Messages& messages, const std::vector<Source>& data,
                            const std::string& model, const model::ModelSubject& subject,
                            const files::ReadOptions& options) {
  if (data.size() == 1) return open_data(messages, data.front(), subject, options);
  std::vector<record::Record> records;
  for (const Source& source : data) {
    records.push_back(open_one(messages, source, subject, options, true));
    try {
      files::make_subject(subject.model(), records.back())->require(records.back());
    } catch (const std::invalid_argument& e) {
      refuse_data(model, records.back(), e);
    }
  }
  for (const fit::Measured& m : files::measurable(subject.model())) {
    const auto declares = [&](const record::Record& r) { return r.deviation_of(*m.channel); };
    if (std::any_of(records.begin(), records.end(), declares) &&
        !std::all_of(records.begin(), records.end(), declares))
      messages.say(
          record::note::unused(fmt::format("std_{} is not in every file: the program ignores it "
                                           "and estimates the noise from the rows",
                                           m.channel->key_unit()),
                               {.key = "std_" + std::string(m.channel->key_unit())}));
  }
  try {
    return record::joined(std::move(records));
  } catch (const std::invalid_argument& e) {
    throw text::InputError(e.what());
  }
}

}  // namespace raceway::session
