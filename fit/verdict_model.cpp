#include "fit/verdict_model.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "fit/candidates.h"
#include "fit/free_parameters.h"
#include "fit/quantity.h"
#include "fit/shaft_prediction.h"

namespace raceway::fit {
namespace {

void set_by_name(Model& model, const std::string& name, double value) {
  for (const ModelParameter& p : model_parameters(model))
    if (p.name == name) p.set(model, value);
}

/// Error over the rows that the diagnosis used, which are those of its baseline, SI.
double rms_error(const std::vector<double>& predicted, const DataSet& data,
                 const Diagnosis& diagnosis) {
  std::unordered_map<int, std::size_t> row_of_line;
  for (std::size_t i = 0; i < data.rows.size(); ++i) row_of_line[data.rows[i].line] = i;
  double square = 0.0;
  for (const RowError& e : diagnosis.baseline.errors) {
    const auto row = row_of_line.find(e.line);
    if (row == row_of_line.end()) return unset;
    square += std::pow(predicted[row->second] - data.rows[row->second].measured, 2);
  }
  return std::sqrt(square / static_cast<double>(diagnosis.baseline.errors.size()));
}

/// Nothing unless the readings have the error `rmse` [N m].
std::optional<EffectModel> effect_model(const Model& model, const DataSet& data,
                                        const Diagnosis& diagnosis,
                                        const std::vector<const RankedEffect*>& set,
                                        const std::vector<BaseShift>& base, double rmse) {
  EffectModel result{.model = model, .readings = {}, .base = {}, .effects = {}};
  const std::vector<effects::Effect> user_made = take_user_made(result.model);
  const std::size_t before = result.model.effects.size();
  for (const RankedEffect* ranked : set) {
    std::optional<effects::Effect> effect =
        find_effect(ranked->id, user_made, subject_of(data.quantity));
    if (!effect) return std::nullopt;
    for (const EffectSize& size : ranked->parameters)
      for (std::size_t k = 0; k < effect->values.size(); ++k)
        if (effect->description->parameters[k].name == size.name) effect->values[k] = size.value;
    result.model.effects.push_back(*std::move(effect));
  }
  for (const BaseShift& shift : base) set_by_name(result.model, shift.name, shift.after);
  result.readings = predict_readings(result.model, data);
  const double error = rms_error(result.readings, data, diagnosis);
  if (!(std::abs(error - rmse) <= 1e-4 * rmse)) return std::nullopt;

  const auto off = [](effects::Effect& e) { e.values = effects::neutral_values(*e.description); };
  Model without = result.model;
  std::for_each(without.effects.begin() + static_cast<std::ptrdiff_t>(before),
                without.effects.end(), off);
  result.base = predict_readings(without, data);
  for (std::size_t k = before; k < result.model.effects.size(); ++k) {
    EffectShare share{.id = std::string(result.model.effects[k].description->id),
                      .readings = result.base};
    if (set.size() > 1) {
      Model one_off = result.model;
      off(one_off.effects[k]);
      share.readings = predict_readings(one_off, data);
    }
    for (std::size_t i = 0; i < share.readings.size(); ++i)
      share.readings[i] = result.readings[i] - share.readings[i];
    result.effects.push_back(std::move(share));
  }
  return result;
}

}  // namespace

std::optional<EffectModel> verdict_model(const Model& model, const DataSet& data,
                                         const Diagnosis& diagnosis) {
  if (diagnosis.sets.empty()) return std::nullopt;
  std::vector<const RankedEffect*> set;
  for (const std::string& id : diagnosis.sets.front()) {
    const auto ranked =
        std::find_if(diagnosis.effects.begin(), diagnosis.effects.end(),
                     [&](const RankedEffect& e) { return e.in_verdict && e.id == id; });
    if (ranked == diagnosis.effects.end()) return std::nullopt;
    set.push_back(&*ranked);
  }
  return effect_model(model, data, diagnosis, set, diagnosis.base_shifts, diagnosis.rmse_after);
}

std::optional<EffectModel> model_with(const RankedEffect& effect, const Model& model,
                                      const DataSet& data, const Diagnosis& diagnosis) {
  return effect_model(model, data, diagnosis, {&effect}, effect.base_shifts, effect.rmse);
}

std::optional<AllRows> errors_on_all_rows(const Model& model, const DataSet& data,
                                          const Diagnosis& diagnosis) {
  const std::optional<EffectModel> found = verdict_model(model, data, diagnosis);
  if (!found) return std::nullopt;
  Model base = model;
  (void)take_user_made(base);
  for (const BaseShift& shift : diagnosis.base_shifts) set_by_name(base, shift.name, shift.before);
  const std::vector<double> before = predict_readings(base, data);
  AllRows result{.before = 0.0, .after = 0.0};
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    const double b = before[i] - data.rows[i].measured;
    const double a = found->readings[i] - data.rows[i].measured;
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    ++result.rows;
    result.before += b * b;
    result.after += a * a;
  }
  result.before = std::sqrt(result.before / result.rows);
  result.after = std::sqrt(result.after / result.rows);
  return result;
}

}  // namespace raceway::fit
