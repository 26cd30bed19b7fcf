#include "io/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "fit/estimated_noise.h"
#include "fit/model_changes.h"
#include "fit/verdict_model.h"
#include "io/diagnosis_results.h"
#include "io/error.h"
#include "io/report_document.h"
#include "io/report_rows.h"
#include "io/report_template.h"
#include "io/results.h"

namespace raceway::io {
namespace {

using json = nlohmann::ordered_json;

/// A number of each row of the data, from the errors of a comparison, which may stand in another
/// order: rows are known by their line.
template <typename Value>
std::vector<double> by_row(const fit::Comparison& comparison, const fit::DataSet& data,
                           Value value) {
  std::unordered_map<int, double> by_line;
  for (const fit::RowError& e : comparison.errors) by_line[e.line] = value(e);
  std::vector<double> values;
  for (const fit::Row& row : data.rows) {
    const auto found = by_line.find(row.line);
    values.push_back(found == by_line.end() ? unset : found->second);
  }
  return values;
}

std::vector<double> predicted_rows(const fit::Comparison& comparison, const fit::DataSet& data) {
  return by_row(comparison, data, [](const fit::RowError& e) { return e.predicted; });
}

/// Standard deviation of each row from a noise model, which is in the order of the comparison.
std::vector<double> noise_rows(const fit::NoiseModel& noise, const fit::Comparison& comparison,
                               const fit::DataSet& data) {
  return by_row(comparison, data, [&](const fit::RowError& e) {
    return noise.whitening.std()[static_cast<Eigen::Index>(e.row)];
  });
}

/// Only the rows that were used: a diagnosis thins large files and leaves out what has no balance.
fit::DataSet used_rows(const fit::DataSet& data, const std::vector<double>& predicted) {
  fit::DataSet used = data;
  used.rows.clear();
  for (std::size_t i = 0; i < data.rows.size(); ++i)
    if (!std::isnan(predicted[i])) used.rows.push_back(data.rows[i]);
  return used;
}

/// Columns of what each explanation is made of.
json explanations_json(const std::vector<fit::EffectModel>& explanations, ReportRows& rows) {
  json list = json::array();
  int effect = 0;
  for (const fit::EffectModel& e : explanations) {
    json effects = json::array();
    for (const fit::EffectShare& share : e.effects)
      effects.push_back(
          {{"id", share.id},
           {"column", rows.add_readings("effect_" + std::to_string(effect++), share.readings)}});
    const std::string of = std::to_string(list.size());
    list.push_back({{"effects", effects},
                    {"base", rows.add_readings("base_" + of, e.base)},
                    {"total", rows.add_readings("with_" + of, e.readings)}});
  }
  return list;
}

json step_json(const fit::ModelChanges& changes) {
  json numbers = json::array();
  for (const fit::ChangedNumber& n : changes.numbers)
    numbers.push_back(
        {{"name", n.name}, {"unit", n.unit}, {"before", n.before}, {"after", n.after}});
  return {{"added", changes.added}, {"removed", changes.removed}, {"numbers", numbers}};
}

}  // namespace

bool report_available() { return !report_template().empty(); }

std::string report_page(const std::string& document) {
  constexpr std::string_view mark = "@DOCUMENT@";
  const std::string_view page = report_template();
  if (page.empty())
    throw InputError(
        "this program was built without reports (-DRACEWAY_REPORT=OFF); build it with Node and npm "
        "and -DRACEWAY_REPORT=ON");
  const std::size_t at = page.find(mark);
  std::string text;
  text.reserve(page.size() + document.size() + document.size() / 16);
  text += page.substr(0, at);
  // In JSON these occur within strings only, where the escape means the same character.
  for (const char c : document) {
    if (c == '<')
      text += "\\u003c";
    else if (c == '>')
      text += "\\u003e";
    else if (c == '&')
      text += "\\u0026";
    else
      text += c;
  }
  return text += page.substr(at + mark.size());
}

std::string comparison_report(const std::vector<std::string>& model_files,
                              const std::vector<fit::Model>& models,
                              const std::vector<fit::Comparison>& comparisons,
                              const fit::DataSet& data) {
  Document document("compare");
  document.add("results", comparison_json(model_files, comparisons, data));
  const fit::Noise& noise = comparisons.front().noise;
  const bool by_row =
      noise.source == fit::NoiseSource::declared || noise.source == fit::NoiseSource::regression;
  std::vector<double> std;
  for (const fit::Row& row : data.rows) std.push_back(by_row ? row.std : noise.rms);
  if (std::isnan(noise.rms))
    if (const auto estimated = fit::estimate_noise_as_diagnosis(models.back(), data)) {
      std = estimated->std;
      document.add("estimated_noise", dump(estimated->rms / fit::text_of(data.quantity).factor));
    }
  json steps = json::array();
  for (std::size_t i = 1; i < models.size(); ++i)
    steps.push_back(step_json(fit::model_changes(models[i - 1], models[i])));
  document.add("steps", dump(steps));
  ReportRows rows(data, std);
  std::vector<Predicted> predicted;
  for (std::size_t i = 0; i < comparisons.size(); ++i)
    predicted.push_back({model_files[i], predicted_rows(comparisons[i], data)});
  rows.add_models(predicted, document);
  rows.finish(document);
  return report_page(document.text());
}

std::string diagnosis_report(const std::string& model_file, const fit::Model& model,
                             const fit::DataSet& all, const fit::Diagnosis& d) {
  Document document("diagnose");
  document.add("results", diagnosis_json(model_file, all, d));
  if (model.shaft) document.add("preload_N", dump(model.shaft->arrangement.preload()));
  const fit::DataSet data = used_rows(all, predicted_rows(d.baseline, all));
  const std::vector<double> base = predicted_rows(d.baseline, data);
  ReportRows rows(data, noise_rows(d.noise, d.baseline, data));
  std::vector<Predicted> models{{"refitted, nothing added", base}};
  const std::optional<fit::EffectModel> verdict = fit::verdict_model(model, data, d);
  if (verdict) {
    std::string ids;
    for (const fit::EffectShare& e : verdict->effects) ids += (ids.empty() ? "" : " and ") + e.id;
    models.push_back({"with " + ids, verdict->readings});
  }
  rows.add_models(models, document);
  std::vector<fit::EffectModel> explanations;
  if (verdict) explanations.push_back(*verdict);
  for (const fit::RankedEffect& effect : d.effects) {
    const bool shown = verdict && std::any_of(verdict->effects.begin(), verdict->effects.end(),
                                              [&](const auto& e) { return e.id == effect.id; });
    if (shown) continue;
    if (auto with = fit::model_with(effect, model, data, d))
      explanations.push_back(*std::move(with));
  }
  document.add("explanations", dump(explanations_json(explanations, rows)));
  rows.finish(document);
  return report_page(document.text());
}

std::string add_report(const std::string& model_file, const fit::DataSet& all,
                       const fit::AddResult& r) {
  Document document("add");
  document.add("results", add_json(model_file, all, r));
  document.add("noise_rms", dump(r.noise.rms / fit::text_of(all.quantity).factor));
  const fit::DataSet data = used_rows(all, predicted_rows(r.before, all));
  ReportRows rows(data, noise_rows(r.noise, r.before, data));
  rows.add_models({{"before, refitted", predicted_rows(r.before, data)},
                   {"after", predicted_rows(r.after, data)}},
                  document);
  rows.finish(document);
  return report_page(document.text());
}

}  // namespace raceway::io
