#include "loop/loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fit/dwells.h"
#include "model/model_changes.h"
#include "report/record_report.h"
#include "results/diagnosis_results.h"
#include "results/results.h"
#include "session/loop.h"
#include "text/error.h"
#include "text/names.h"
#include "text/units.h"

namespace raceway::session {
namespace {

/// What the data do not allow, with the names of both files.
template <typename Ask>
auto with_data(const std::string& model, const record::Record& data, const Ask& ask) {
  try {
    return ask();
  } catch (const std::invalid_argument& e) {
    refuse_data(model, data, e);
  }
}

/// The dwells of a record; none where a reading depends on the rows before it.
fit::Averaged dwells_of(const LoopModel& model, const record::Record& data) {
  const std::shared_ptr<const fit::Subject> subject = model.as_written(data);
  if (subject->has_memory() || subject->approximates()) return {};
  return fit::average_dwells(data);
}

/// Returns the model for a verdict, with assumed values free if the record determines them.
std::shared_ptr<const fit::Subject> of_verdict(const LoopQuestion& asked) {
  return asked.model->with_assumed_free(asked.subject, asked.data, asked.per_record);
}

/// Returns the parameters that are free only in the model for a verdict.
Names assumed_in(const LoopQuestion& asked, const fit::Subject& of_verdict) {
  const Names given = asked.subject->free();
  Names names = of_verdict.free();
  std::erase_if(names, [&](const std::string& name) {
    return std::find(given.begin(), given.end(), name) != given.end();
  });
  return names;
}

std::string id_of(const std::string& parameter) { return parameter.substr(0, parameter.find('.')); }

/// Fitted values of the assumed parameters.
struct AssumedValues {
  std::string text;        ///< the corrected data; empty if no value changed
  bool believable = true;  ///< true if each value is in its plausible range
};

constexpr double unchanged =
    0.01;  // our choice: a smaller change of a factor is not worth a warning

AssumedValues assumed_values(const LoopQuestion& asked, const fit::Subject& of_verdict,
                             std::span<const record::Parameter> fitted) {
  AssumedValues found;
  for (const std::string& name : assumed_in(asked, of_verdict))
    for (const record::Parameter& p : fitted) {
      if (p.name != name) continue;
      if (std::abs(p.value - p.neutral) < unchanged) continue;
      found.text +=
          (found.text.empty() ? "" : ", ") + of_verdict.correction(id_of(name), {&p.value, 1});
      found.believable &= p.value >= p.plausible_lower && p.value <= p.plausible_upper;
    }
  return found;
}

void tell_of_assumed(const AssumedValues& values, std::vector<record::Note>& messages) {
  if (values.text.empty()) return;
  messages.push_back(record::note::check_data(fmt::format(
      "the model marks viscosity_100C_mm2_s as assumed, so the fit also changed this value: {}; "
      "enter the value of the oil data sheet and remove the mark",
      values.text)));
}

/// Warns of a temperature column that [columns] does not assign. Its variation would count as noise
/// or as another effect.
void tell_of_no_temperature(const record::Record& data, std::vector<record::Note>& messages) {
  const bool filled_in =
      std::any_of(data.notes.begin(), data.notes.end(), [](const record::Note& note) {
        return note.code == &record::note::filled_in && note.place.key == record::temperature.name;
      });
  if (!filled_in) return;
  for (const record::Column& column : data.columns)
    if (column.channel->role == record::Role::kept &&
        text::find_unit(column.channel->unit, text::Dimension::temperature))
      messages.push_back(record::note::limits(
          fmt::format("the model uses one temperature for all rows, but the record has the "
                      "temperature {}: if it is the temperature of the oil, assign it to "
                      "temperature_C in [columns]",
                      column.channel->name),
          {.key = std::string(record::temperature.name)}));
}

/// Records that were fitted as one, where nothing explains them together.
void tell_of_records(const LoopQuestion& asked, verdict::Diagnosis& found) {
  const bool unexplained = found.verdict == verdict::Verdict::not_in_catalogue ||
                           found.verdict == verdict::Verdict::effect_like;
  if (asked.data.parts.size() < 2 || !asked.per_record.empty() || !unexplained) return;
  std::vector<std::string> names;
  for (const record::Parameter& p : found.base) names.push_back(p.name);
  if (names.empty()) return;
  found.messages.push_back(record::note::check_data(
      fmt::format("all records are fitted with the same {0}. If the rig changed between them, for "
                  "example its oil, try --per-record {1}",
                  text::listed(names), fmt::join(names, ",")),
      {.key = "--per-record"}));
}

/// Rows of a logger become dwells, unless `rows` are to stay apart; the record says so.
void average(Messages& messages, const LoopModel& model, record::Record& data, bool rows) {
  if (rows) {
    const std::shared_ptr<const fit::Subject> subject = model.as_written(data);
    if (subject->has_memory() || subject->approximates())
      messages.say(record::note::unused(
          "--rows has no effect: the rows of a record over time are never averaged",
          {.key = "rows"}));
    return;
  }
  fit::Averaged averaged = dwells_of(model, data);
  if (!averaged.any()) return;
  const record::Note said = record::note::averaged(
      averaged.statement() + "; use --rows to keep all rows", {.file = data.source});
  messages.say(said);
  data = std::move(averaged.record);
  data.notes.push_back(said);
}

}  // namespace

LoopQuestion ask(Messages& messages, const Source& model, const std::vector<Source>& data,
                 const LoopOptions& options) {
  LoopQuestion asked{.model = open_loop_model(messages, model, options),
                     .per_record = options.per_record};
  asked.data = asked.model->read(messages, options.reading.sources(data), options.reading);
  average(messages, *asked.model, asked.data, options.rows);
  asked.subject = asked.model->for_fit(messages, asked.data, options.per_record);
  return asked;
}

verdict::Calibration calibrate(const LoopQuestion& asked,
                               const verdict::CalibrateOptions& options) {
  verdict::Calibration found = with_data(asked.source(), asked.data, [&] {
    return loop::calibrate(*asked.subject, asked.data, options);
  });
  tell_of_scale(asked.data, found.messages);
  return found;
}

verdict::Diagnosis diagnose(const LoopQuestion& asked, const verdict::DiagnoseOptions& options) {
  verdict::Diagnosis found;
  with_data(asked.source(), asked.data, [&] {
    const std::shared_ptr<const fit::Subject> subject = of_verdict(asked);
    found = loop::diagnose(*subject, asked.data, options);
    const AssumedValues values = assumed_values(asked, *subject, found.base);
    if (!values.believable)
      found = loop::diagnose(*asked.subject, asked.data, options);
    else
      tell_of_assumed(values, found.messages);
  });
  tell_of_no_temperature(asked.data, found.messages);
  tell_of_records(asked, found);
  tell_of_scale(asked.data, found.messages);
  return found;
}

verdict::AddResult add(const LoopQuestion& asked, const Names& effects) {
  verdict::AddResult found = with_data(asked.source(), asked.data, [&] {
    const Names ids = asked.model->meant(effects, asked.data);
    std::shared_ptr<const fit::Subject> subject = of_verdict(asked);
    for (const std::string& name : assumed_in(asked, *subject))
      if (std::find(ids.begin(), ids.end(), id_of(name)) != ids.end()) subject = asked.subject;
    verdict::AddResult result = loop::add(*subject, ids, asked.data);
    const AssumedValues values = assumed_values(asked, *subject, result.calibration.parameters);
    if (!values.believable)
      result = loop::add(*asked.subject, ids, asked.data);
    else
      tell_of_assumed(values, result.messages);
    return result;
  });
  tell_of_scale(asked.data, found.messages);
  return found;
}

std::vector<double> predict(const LoopQuestion& asked) {
  return with_data(asked.source(), asked.data, [&] {
    asked.subject->require(asked.data);
    return fit::predict(*asked.subject, asked.data);
  });
}

std::string json(const LoopQuestion& asked, const verdict::Calibration& found) {
  return results::calibration_json(found, asked.data);
}

std::string json(const LoopQuestion& asked, const verdict::Diagnosis& found) {
  return results::diagnosis_json(asked.source(), asked.data, found);
}

std::string json(const LoopQuestion& asked, const verdict::AddResult& found) {
  return results::add_json(asked.source(), asked.data, found);
}

std::string page(const LoopQuestion& asked, const verdict::Diagnosis& found) {
  return asked.model->page(asked.data, found);
}

std::string page(const LoopQuestion& asked, const verdict::AddResult& found) {
  return asked.model->page(asked.data, found);
}

FittedTexts fitted_texts(const LoopQuestion& asked, const verdict::Calibration& found) {
  return asked.model->fitted_texts(asked.data, found);
}

std::vector<std::vector<verdict::Comparison>> ComparedModels::errors() const {
  std::vector<std::vector<verdict::Comparison>> list;
  for (const ComparedModel& model : models) list.push_back(model.errors);
  return list;
}

std::string ComparedModels::json() const {
  std::vector<correction::Beyond> beyond;
  for (const ComparedModel& model : models)
    if (model.beyond) beyond.push_back(*model.beyond);
  return results::comparison_json(names, errors(), data, beyond);
}

std::string ComparedModels::page() const {
  std::vector<report::ModelOfPage> facts;
  std::vector<model::Model> used;
  std::vector<report::DrawnModel> drawn;
  for (const ComparedModel& model : models) {
    drawn.push_back(model.drawn);
    if (!model.facts) continue;
    facts.push_back(*model.facts);
    used.push_back(model.facts->model);
  }
  if (models.back().subject->approximates())
    return report::record_report("compare", json(), data, drawn, facts,
                                 model::changes_between(used));
  return report::comparison_report(names, used, errors(), data, facts);
}

ComparedModels compare(Messages& messages, const std::vector<Source>& models,
                       const std::vector<Source>& data, const CompareOptions& how,
                       const LoopOptions& options) {
  LoopModels opened;
  for (const Source& source : models) {
    opened.push_back(open_loop_model(messages, source, options, opened.size()));
    opened.back()->stand_beside(messages, *opened.front());
  }
  ComparedModels result{.data = opened.front()->read(messages, options.reading.sources(data),
                                                     options.reading, opened)};
  average(messages, *opened.front(), result.data, options.rows);
  for (const auto& model : opened) {
    const std::string& source = model->about().source;
    result.names.push_back(source);
    result.models.push_back(with_data(source, result.data, [&] {
      return model->compared(messages, result.data, how, options.per_record);
    }));
  }
  if (result.models.front().beyond && how.refit.empty() && how.zero != "none")
    messages.say(record::note::assumed(
        how.zero == "first" ? "each run is compared with its first error subtracted (--zero first)"
                            : "each run is compared with its mean error subtracted; --zero none "
                              "keeps the mean error"));
  // The noise is that of the data: one for all models, by the last.
  for (ComparedModel& model : result.models)
    verdict::estimate_unknown_noise(*result.models.back().subject, result.data, model.errors);
  if (!how.refit.empty())
    messages.say(record::note::assumed(fmt::format(
        "{} {} refitted to {} in each model; all other values are from the model files",
        fmt::join(how.refit, " and "), how.refit.size() == 1 ? "is" : "are", result.data.source)));
  if (!options.per_record.empty())
    messages.say(record::note::assumed(fmt::format(
        "{} {} refitted to each record separately in each model",
        fmt::join(options.per_record, " and "), options.per_record.size() == 1 ? "is" : "are")));
  return result;
}

std::string suggested_columns(Messages& messages, const Source& model, const Source& data,
                              LoopOptions options) {
  if (data.name.ends_with(".toml"))
    throw text::InputError(
        data.name + ": this is a model file; measurements (CSV) are expected here",
        {.file = data.name});
  const Source files = options.reading.sources({data}).front();
  const std::unique_ptr<LoopModel> opened =
      open_any_correction(messages, model, std::move(options));
  return opened->suggested_columns(files);
}

std::string CheckedModel::json() const {
  return results::check_json(model.name, check, model.defaults, notes,
                             over_time ? &*over_time : nullptr);
}

CheckedModel check(Messages& messages, const Source& source, const Source& data,
                   const LoopOptions& options) {
  const std::unique_ptr<LoopModel> model = open_loop_model(messages, source, options);
  CheckedModel result{
      .model = model->about(),
      .data = model->read(messages, options.reading.sources({data}), options.reading)};
  result.over_time = model->over_time(result.data);
  const fit::Averaged averaged = dwells_of(*model, result.data);
  result.check = with_data(result.model.source, result.data, [&] {
    const std::shared_ptr<const fit::Subject> written = model->as_written(result.data);
    const auto informed = result.over_time ? written->informed_by(result.data) : nullptr;
    return loop::check(informed ? *informed : *written, result.data,
                       averaged.any() ? &averaged.record : nullptr);
  });
  result.notes = result.model.notes;
  result.notes.insert(result.notes.end(), result.data.notes.begin(), result.data.notes.end());
  const auto tell = [&](record::Note said) {
    said.place.file = result.data.source;
    messages.say(said);
    result.notes.push_back(std::move(said));
  };
  if (averaged.any()) tell(record::note::averaged(averaged.statement()));
  if (!result.check.problem.empty()) tell(record::note::no_prediction(result.check.problem));
  if (result.over_time)  // the document has a list of these
    messages.say(result.over_time->warnings);
  else if (!result.check.runs_coincide_with.empty())
    tell(record::note::plan(
        fmt::format("each run has a different {0}, so an effect of {0} cannot be separated from a "
                    "difference between runs. For further measurements, plan at least two runs for "
                    "each level, or all levels in each run",
                    result.check.runs_coincide_with)));
  return result;
}

}  // namespace raceway::session
