#include "session/correction_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "correction/alignment.h"
#include "correction/band.h"
#include "correction/learning.h"
#include "fit/noise.h"
#include "report/record_report.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/units.h"

namespace raceway::session {
namespace {

/// Of the readings, which scatter about the displacement by `noise`; one constant taken off each
/// run.
double share_within(const std::vector<double>& band, double noise, std::span<const double> read,
                    const std::vector<double>& predicted) {
  constexpr double two_sided = 1.96;
  std::size_t readings = 0, within = 0;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (!std::isfinite(read[k]) || !std::isfinite(predicted[k])) continue;
    ++readings;
    if (std::abs(read[k] - predicted[k]) <= std::hypot(band[k], two_sided * noise)) ++within;
  }
  return readings > 0 ? static_cast<double>(within) / static_cast<double>(readings) : unset;
}

results::Corrected corrected_by(const correction::Model& model, const record::Record& record,
                                std::vector<record::Note>& messages) {
  const auto subject = correction::aligned(model, record, correction::Zero::none);
  results::Corrected result{.displacement = model.displacement,
                            .initial_state = model.initial_state,
                            .predicted = fit::predict(*subject, record)};
  const auto series = std::make_shared<const correction::Series>(record);
  result.parts = correction::contributions(subject->model(), *series);
  result.beyond = correction::beyond_range(model, *series);
  append(messages, notes_of(record::note::beyond_range, range_notes(model, *series, result.beyond),
                            {.file = record.source}));
  if (model.left)
    result.band = correction::band_of(*subject, model, series, result.beyond).half_width();
  result.trust = correction::trust_on(model, {}, unset, result.beyond);
  if (record.has(*model.displacement)) {
    append(messages, notes_of(record::note::assumed, fitted_start(model), {.file = record.source}));
    const auto zeroed = correction::aligned(model, record, correction::Zero::mean);
    const std::span<const double> read = record.values(*model.displacement);
    const std::vector<double> predicted = fit::predict(*zeroed, record);
    result.metrics = correction::metrics(read, predicted);
    result.noise = std::isfinite(model.measured_std)
                       ? model.measured_std
                       : fit::noise_of_neighbours(record, *model.displacement);
    result.trust = correction::trust_on(model, result.metrics,
                                        correction::uncorrected_rms(model, record), result.beyond);
    if (model.left)
      result.readings_in_band = share_within(
          result.band, std::isfinite(result.noise) ? result.noise : 0.0, read, predicted);
  }
  const auto bad = std::find_if(result.predicted.begin(), result.predicted.end(),
                                [](double v) { return !std::isfinite(v); });
  if (bad != result.predicted.end())
    messages.push_back(record::note::no_prediction(
        fmt::format("{}: no displacement is predicted from {} on, because the input of a delay "
                    "element is outside the range of this element",
                    model.displacement->name,
                    record.place(static_cast<std::size_t>(bad - result.predicted.begin())))));
  return result;
}

/// As they were compared: with the constant that leaves least, where something was read.
std::vector<report::DrawnModel> drawn(const SeriesQuestion& asked) {
  std::vector<report::DrawnModel> list;
  for (const correction::Model& model : asked.file.models)
    list.push_back(
        {.name = std::string(model.displacement->words),
         .subject = correction::aligned(
             model, asked.data,
             asked.data.has(*model.displacement) ? correction::Zero::mean : correction::Zero::none),
         .held_out = {},
         .defaults = asked.file.defaults});
  return list;
}

/// "4h", "30 min" in seconds.
double duration(const std::string& text, const std::string& flag) {
  const auto wrong = [&](const std::string& why) {
    throw text::InputError(fmt::format("{} {}: {}", flag, text::quoted(text), why), {.key = flag});
  };
  double value = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  const std::string_view name(end, static_cast<std::size_t>(last - end));
  const text::Unit* const unit =
      error == std::errc() ? text::find_unit(name, text::Dimension::time) : nullptr;
  if (!unit) wrong("write a number and its unit (s, min, h, d), such as 4h");
  const double seconds = unit->to_SI(value);
  if (!(seconds > 0.0) || !(seconds <= 1e9)) wrong("must be above 0 and at most 1e9 s");
  return seconds;
}

correction::LearningOptions options_of(const LearningChoices& choices) {
  correction::LearningOptions options;
  if (!choices.every.empty()) options.every = duration(choices.every, "--every");
  if (!choices.forget.empty()) options.forgetting = duration(choices.forget, "--forget");
  return options;
}

/// What was assumed, where the model does not say.
std::vector<std::string> notes_on(const correction::Model& model) {
  std::vector<std::string> notes;
  if (std::isnan(model.tolerance))
    notes.push_back(fmt::format(
        "{}: the model has no {}: the program assumes a standard deviation of {:g} {} for the "
        "error of the model, and does not calculate when the next reading is needed",
        model.displacement->name, correction::in_unit_of(model, "tolerance_um"),
        correction::usual_misfit / um, correction::unit_of(model)));
  if (std::isnan(model.measured_std))
    notes.push_back(
        fmt::format("{}: the model has no {}: the program assumes a standard deviation of {:g} {} "
                    "for the readings",
                    model.displacement->name, correction::in_unit_of(model, "measurement_std_um"),
                    correction::usual_reading_std / um, correction::unit_of(model)));
  if (model.range.empty())
    notes.push_back(
        fmt::format("{}: the model has no [correction.range], so learning tests no additional "
                    "lags; identify writes this table",
                    model.displacement->name));
  return notes;
}

std::vector<std::string> warnings_on(const results::Learnt& one, const record::Record& record) {
  constexpr double an_hour = 3600.0;
  std::vector<std::string> list;
  const auto place = [&](std::size_t row) {
    return fmt::format("{}: {} ({:.4g} h)", one.displacement->name, record.place(row),
                       record.value(record::time, row) / an_hour);
  };
  for (const correction::OfferedReading& r : one.learning.readings)
    if (!r.learnt)
      list.push_back(fmt::format(
          "{}: the reading is {:.4g} {}, but {:.4g} +- {:.2g} was expected: the reading is "
          "rejected and not used for learning",
          place(r.row), r.reading / um, one.displacement->unit, r.predicted / um, r.std / um));
  for (const correction::IdentificationDue& d : one.learning.due)
    list.push_back(fmt::format("{}: a new identification is due: {}", place(d.row), d.reason));
  return list;
}

/// Puts record and model before what cannot be done with them.
template <typename Work>
auto on_record(const SeriesQuestion& asked, const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& e) {
    throw text::InputError(
        fmt::format("{} with {}: {}", asked.data.source, asked.file.source, e.what()),
        {.file = asked.data.source});
  }
}

}  // namespace

std::string CorrectionRun::json() const {
  return results::corrected_json(asked.file.source, asked.data, corrected, warnings);
}

std::string CorrectionRun::csv() const { return results::corrected_text(asked.data, corrected); }

std::string CorrectionRun::page() const {
  return report::record_report("correct", json(), asked.data, drawn(asked));
}

CorrectionRun correct(SeriesQuestion asked) {
  CorrectionRun run{.asked = std::move(asked)};
  for (const correction::Model& model : run.asked.file.models)
    run.corrected.push_back(
        on_record(run.asked, [&] { return corrected_by(model, run.asked.data, run.warnings); }));
  return run;
}

void LearningChoices::check() const { (void)options_of(*this); }

std::string LearningRun::json() const {
  std::vector<record::Note> messages = warnings;
  append(messages, notes);
  return results::learnt_json(asked.file.source, asked.data, learnt, messages);
}

std::string LearningRun::csv() const { return results::learnt_text(asked.data, learnt); }

std::string LearningRun::text() const {
  std::vector<correction::Model> models;
  for (const results::Learnt& one : learnt) {
    models.push_back(one.learning.model);
    models.back().range.clear();  // what the file has stays
  }
  return files::with_corrections(asked.file, models);
}

LearningRun learn(SeriesQuestion asked, const LearningChoices& choices) {
  LearningRun run{.asked = std::move(asked)};
  const correction::LearningOptions options = options_of(choices);
  for (const correction::Model& model : run.asked.file.models) {
    run.learnt.push_back({model.displacement, on_record(run.asked, [&] {
                            return correction::learn(model, run.asked.data, options);
                          })});
    const record::Place place{.file = run.asked.data.source};
    append(run.warnings,
           notes_of(record::note::due, warnings_on(run.learnt.back(), run.asked.data), place));
    append(run.warnings,
           notes_of(record::note::beyond_range, range_notes(model, run.asked.data), place));
    append(run.notes,
           notes_of(record::note::assumed, notes_on(model), {.file = run.asked.file.source}));
    if (run.learnt.back().learning.error.readings == 0)
      run.notes.push_back(
          record::note::assumed(fmt::format("{}: all readings were used for learning; use --every "
                                            "to keep some readings for a test of the prediction",
                                            model.displacement->name)));
  }
  return run;
}

}  // namespace raceway::session
