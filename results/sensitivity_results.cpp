#include "results/sensitivity_results.h"

#include <algorithm>
#include <cmath>

#include "text/detail/json_text.h"

namespace raceway::results {
namespace {

text::json reasons_json(const std::vector<std::pair<std::string, std::string>>& reasons) {
  text::json list = text::json::array();
  for (const auto& [name, why] : reasons) list.push_back({{"name", name}, {"why", why}});
  return list;
}

text::json global_json(const fit::SobolIndex& index) {
  return {{"first", index.first},
          {"first_error", index.first_error},
          {"total", index.total},
          {"total_error", index.total_error}};
}

text::json datum_json(const Sensitivity& s, const PredictionSensitivity& p, std::size_t k) {
  const VariedDatum& datum = s.data[k];
  const LocalSensitivity& local = p.local[k];
  text::json one{{"name", datum.name},
                 {"value", datum.value},
                 {"spread", datum.spread},
                 {"spread_from", datum.spread_from},
                 {"origin", datum.origin},
                 {"derivative", local.derivative},
                 {"derivative_error", local.derivative_error},
                 {"elasticity", local.elasticity},
                 {"change", local.change},
                 {"low", local.low},
                 {"high", local.high},
                 {"share", local.share},
                 {"kink", local.kink},
                 {"steps_disagree", local.steps_disagree},
                 {"one_sided", local.one_sided}};
  if (!p.global) return one;
  const auto at = std::find(s.sampled.begin(), s.sampled.end(), k);
  one["global"] =
      at == s.sampled.end()
          ? text::json(nullptr)
          : global_json(p.global->inputs[static_cast<std::size_t>(at - s.sampled.begin())]);
  return one;
}

text::json prediction_json(const Sensitivity& s, const PredictionSensitivity& p) {
  text::json one{{"name", p.name}};
  for (std::size_t k = 0; k < s.inputs.size(); ++k) one[s.inputs[k]] = s.states[p.state][k];
  one["value"] = p.value;
  if (p.global) {
    one["mean"] = p.global->mean;
    one["std"] = p.global->std;
    one["complete_samples"] = p.global->complete;
    one["cannot_tell"] = p.cannot_tell;
  }
  text::json data = text::json::array();
  for (const std::size_t k : p.order) data.push_back(datum_json(s, p, k));
  one["data"] = std::move(data);
  return one;
}

}  // namespace

bool Sensitivity::converged() const {
  return std::all_of(predictions.begin(), predictions.end(),
                     [](const PredictionSensitivity& p) { return std::isfinite(p.value); });
}

std::string sensitivity_json(const Sensitivity& s) {
  text::json predictions = text::json::array();
  for (const PredictionSensitivity& p : s.predictions) predictions.push_back(prediction_json(s, p));
  text::json document{{"model", s.source},
                      {"bearing", s.model},
                      {"predictions", std::move(predictions)},
                      {"does_not_enter", s.does_not_enter},
                      {"not_varied", reasons_json(s.not_varied)}};
  if (s.samples == 0) return text::text(document);
  text::json global{{"samples", s.samples},
                    {"seed", s.seed},
                    {"evaluations", s.evaluations},
                    {"not_sampled", reasons_json(s.not_sampled)},
                    {"failed", s.failed}};
  if (s.failed > 0) {
    text::json at = text::json::object();
    for (std::size_t k = 0; k < s.first_failed.size(); ++k)
      at[s.data[s.sampled[k]].name] = s.first_failed[k];
    global["first_failed"] = {{"why", s.why_failed}, {"data", std::move(at)}};
  }
  document["global"] = std::move(global);
  return text::text(document);
}

}  // namespace raceway::results
