#include "session/identification.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "correction/alignment.h"
#include "correction/lag_bank.h"
#include "correction/series.h"
#include "record/series_channel.h"
#include "session/open_input.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::session {
namespace {

/// "2" or "1:3"
std::pair<int, int> orders_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto number = [&](std::string_view part) {
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size() || value < 1 || value > 6)
      throw text::InputError(
          fmt::format(
              "--order {}: must be a number of sections from 1 to 6, or a range such as 1:3", text),
          {.key = "--order"});
    return value;
  };
  const std::string_view all = text;
  if (colon == text.npos) return {number(all), number(all)};
  const std::pair result{number(all.substr(0, colon)), number(all.substr(colon + 1))};
  if (result.first > result.second)
    throw text::InputError(
        fmt::format("--order {}: the first number must not be above the second", text),
        {.key = "--order"});
  return result;
}

/// Time constants of a bank of lags [s], none for "auto".
std::vector<double> lags_of(const std::vector<std::string>& texts) {
  std::vector<double> list;
  if (texts.size() == 1 && texts.front() == "auto") return list;
  for (const std::string& text : texts) {
    double value = -1.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr double longest = 1e7;
    if (error != std::errc() || end != text.data() + text.size() || !(value >= 0.0) ||
        value > longest)
      throw text::InputError(fmt::format("--lags {}: must be auto, or time constants from 0 (no "
                                         "lag) to 1e7 s, separated by commas, such as 0,1200,3600",
                                         text),
                             {.key = "--lags"});
    if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
  }
  return list;
}

/// Columns that may drive a channel, by name; "all" means every input that varies.
std::vector<const record::Channel*> offered(const std::vector<std::string>& names,
                                            const record::Record& record) {
  std::vector<const record::Channel*> list;
  if (names.size() == 1 && names.front() == "all") {
    for (const record::Column& c : record.columns) {
      const auto [low, high] = std::minmax_element(c.values.begin(), c.values.end());
      if (c.channel->is_input() && *low < *high) list.push_back(c.channel);
    }
    return list;
  }
  for (const std::string& name : names) {
    const record::Channel* const c = record::series_channel(name);
    if (!c || !c->is_input() || !record.has(*c)) {
      std::vector<std::string> known;
      for (const record::Column& column : record.columns) known.emplace_back(column.channel->name);
      throw text::InputError(fmt::format("--inputs {}: {} does not have this input{}", name,
                                         record.source, text::suggestion(name, known)),
                             {.file = record.source, .key = "--inputs"});
    }
    list.push_back(c);
  }
  return list;
}

correction::Identification bank(const correction::Model& model, const record::Record& record,
                                const IdentifyChoices& choices) {
  const std::vector<std::string> all{"all"};
  return correction::identify_lag_bank(
      model, record,
      {.inputs = offered(choices.inputs.empty() ? all : choices.inputs, record),
       .time_constants = lags_of(choices.lags),
       .progress = choices.progress,
       .cancelled = choices.cancelled});
}

correction::Identification sections(const correction::Model& model, const record::Record& record,
                                    const IdentifyChoices& choices) {
  const auto [lowest, highest] = orders_of(choices.order);
  return correction::identify(model, record,
                              {.lowest_order = lowest,
                               .highest_order = highest,
                               .offered = offered(choices.inputs, record),
                               .progress = choices.progress,
                               .cancelled = choices.cancelled});
}

correction::Identification identified(Messages& messages, SeriesQuestion& asked,
                                      const correction::Model& model,
                                      const IdentifyChoices& choices) {
  const std::string& source = asked.file.source;
  require_readings(model, asked.data);
  prepare_fit(messages, model, source, asked.data);
  if (choices.baseline == "regression") {
    try {
      return correction::regression_baseline(model, offered(choices.inputs, asked.data),
                                             asked.data);
    } catch (const std::invalid_argument& e) {
      refuse_data(source, asked.data, e);
    }
  }
  try {
    return choices.lags.empty() ? sections(model, asked.data, choices)
                                : bank(model, asked.data, choices);
  } catch (const std::invalid_argument& e) {
    throw text::InputError(fmt::format("{} with {}: {}", asked.data.source, source, e.what()),
                           {.file = asked.data.source});
  }
}

correction::ArxBaseline arx_baseline(const SeriesQuestion& asked, const correction::Model& model,
                                     const IdentifyChoices& choices) {
  const auto [lowest, highest] = orders_of(choices.order);
  require_readings(model, asked.data);
  try {
    return correction::arx_baseline(model, offered(choices.inputs, asked.data), asked.data, lowest,
                                    highest);
  } catch (const std::invalid_argument& e) {
    refuse_data(asked.file.source, asked.data, e);
  }
}

/// Errors of a model on a record that was not used for its fit.
results::Validation validated(const correction::Model& model, const record::Record& other,
                              std::vector<record::Note>& warnings) {
  require_readings(model, other);
  const auto subject = correction::aligned(model, other, correction::Zero::mean);
  const correction::Series series(other);
  const correction::Beyond beyond = correction::beyond_range(model, series);
  append(warnings, notes_of(record::note::beyond_range, range_notes(model, series, beyond),
                            {.file = other.source}));
  return {.data = other.source,
          .metrics =
              correction::metrics(other.values(*model.displacement), fit::predict(*subject, other)),
          .uncorrected = correction::uncorrected_rms(model, other),
          .rows_beyond_range = beyond.rows()};
}

std::vector<correction::Model> models_of(const std::vector<correction::Identification>& found) {
  std::vector<correction::Model> models;
  for (const correction::Identification& one : found) models.push_back(one.model);
  return models;
}

}  // namespace

void IdentifyChoices::check() const {
  (void)orders_of(order);
  (void)lags_of(lags);
}

Identified identify(Messages& messages, SeriesQuestion asked, const IdentifyChoices& choices) {
  Identified answer{.asked = std::move(asked), .baseline = choices.baseline};
  for (const correction::Model& model : answer.asked.file.models)
    answer.found.push_back(identified(messages, answer.asked, model, choices));
  return answer;
}

void Identified::validate(Messages& messages, const Source& other, const Reading& reading) {
  const record::Record record =
      open_series(messages, other, models_of(found), reading.options(asked.file.columns));
  for (correction::Identification& one : found) {
    validations.push_back(validated(one.model, record, validation_warnings));
    one.model.evidence->error = validations.back().metrics.rms;
    one.model.evidence->uncorrected = validations.back().uncorrected;
    one.model.evidence->other_record = true;
  }
}

std::string Identified::json() const {
  return results::identification_json(asked.file.source, asked.data, found, validations);
}

std::string Identified::text() const {
  const std::vector<correction::Model> models = models_of(found);
  return baseline.empty()
             ? files::with_corrections(asked.file, models)
             : files::new_corrections(models, "Multiple linear regression on " + asked.data.source);
}

ArxModels identify_arx(SeriesQuestion asked, const IdentifyChoices& choices) {
  ArxModels answer{.asked = std::move(asked)};
  for (const correction::Model& model : answer.asked.file.models)
    answer.found.emplace_back(model.displacement, arx_baseline(answer.asked, model, choices));
  return answer;
}

bool ArxModels::stable() const {
  return std::all_of(found.begin(), found.end(),
                     [](const auto& one) { return one.second.best() != nullptr; });
}

std::string ArxModels::json() const {
  return results::arx_json(asked.file.source, asked.data, found);
}

ArxModels::Text ArxModels::text() const {
  std::vector<correction::Model> models;
  Text result;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto& [displacement, baseline] = found[k];
    const correction::ArxFit* const best = baseline.best();
    if (!best)
      throw text::InputError(
          fmt::format("{}: ARX of {}: no order is stable, so the simulation grows without limit. "
                      "Omit --baseline: identify then fits sections, which are always stable",
                      asked.data.source, displacement->name),
          {.file = asked.data.source, .key = "--baseline"});
    models.push_back(correction::with_arx(asked.file.models[k], baseline, *best));
    result.notes.push_back(record::note::limits(
        fmt::format("{}: ARX of order {} has the smallest RMS error over the second half of the "
                    "record ({:.3g} {unit} simulated, {:.3g} {unit} one step ahead). A control "
                    "uses the simulation and must calculate one step every {:.10g} s",
                    displacement->name, best->order, best->second_half.rms / um,
                    best->one_step.rms / um, baseline.sampling,
                    fmt::arg("unit", displacement->unit)),
        {.file = asked.data.source}));
  }
  result.text = files::new_corrections(models, "ARX models of " + asked.data.source);
  return result;
}

}  // namespace raceway::session
