#include "correction/effect_kind.h"

#include <algorithm>
#include <stdexcept>

#include "correction/catalogue.h"
#include "correction/effects/shared_numbers.h"
#include "correction/own_effect.h"
#include "correction/simulation.h"

namespace raceway::correction {
namespace {

bool is_among(std::span<const Channel* const> columns, const Channel& column) {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const Channel* c) { return *c == column; });
}

bool is_gain(const record::NumberCard& number) { return number.unit == gain_number.unit; }

}  // namespace

bool Surroundings::varies(const Channel& column) const { return is_among(varying, column); }

std::vector<const Channel*> Surroundings::unused(bool (*is_of_kind)(const Channel&)) const {
  const std::vector<const Channel*> used = inputs_of(model);
  std::vector<const Channel*> list;
  for (const Channel* c : varying)
    if (is_of_kind(*c) && !is_among(used, *c)) list.push_back(c);
  return list;
}

std::vector<Effect> EffectKind::possible(const Surroundings&) const { return {}; }

std::vector<double> EffectKind::choices(std::size_t, const Surroundings&) const { return {}; }

std::span<const record::NumberCard> EffectKind::numbers(const Effect&) const {
  return card().numbers;
}

bool EffectKind::may_end_before(std::size_t) const { return false; }

bool EffectKind::is_proportional(std::size_t number) const {
  const record::NumberCard& n = card().numbers[number];
  return is_gain(n) || n.unit == "um";
}

Interval EffectKind::bounds(const Effect& effect, std::size_t number, const Model& model,
                            const TimeConstantLimits& limits) const {
  const record::NumberCard& n = numbers(effect)[number];
  if (n.name != time_constant_number.name) return {n.lower, n.upper};
  return {std::max(n.lower, shortest_time_constant(input(effect, model), limits)),
          std::min(n.upper, limits.longest)};
}

std::string EffectKind::key(const Effect& effect, std::size_t number, const Model& model) const {
  const record::NumberCard& n = numbers(effect)[number];
  if (!is_gain(n)) return std::string(n.name) + (n.unit == "um" ? "_um" : "");
  const Input driving = input(effect, model);
  return driving.is_none() ? "gain_um" : "gain_um_" + std::string(driving.key_unit());
}

Input EffectKind::input(const Effect& effect, const Model& model) const {
  if (!effect.columns.empty())
    return {.name = std::string(effect.columns.front()->name), .columns = effect.columns};
  const DrivenChannel* const of = find_channel(model, effect.where);
  return of ? of->input : Input{};
}

std::vector<const Channel*> EffectKind::other_columns(const Effect&) const { return {}; }

std::vector<fit::Fault> EffectKind::faults(const FittedRecord&) const { return {}; }

Share EffectKind::share(const Effect&, const Model&) const { return {}; }

void EffectKind::change(const Effect&, const Model&, Answer&) const {}

Effect EffectKind::at(std::string where, std::vector<const Channel*> columns) const {
  Effect e{.id = std::string(card().id), .where = std::move(where), .columns = std::move(columns)};
  for (const record::NumberCard& n : numbers(e)) e.values.push_back(n.initial);
  return e;
}

std::string unit_of(const Effect& effect, std::size_t number, const Model& model) {
  const record::NumberCard& n = kind_of(effect).numbers(effect)[number];
  if (!is_gain(n)) return in_unit_of(model, n.unit);
  const Input driving = input_of(effect, model);
  return in_unit_of(model, driving.is_none() ? "um" : "um/" + std::string(driving.unit()));
}

std::string key_of(const Effect& effect, std::size_t number, const Model& model) {
  return in_unit_of(model, kind_of(effect).key(effect, number, model));
}

DrivenShare lag_of_input(const EffectKind& kind, const Effect& effect, const Model& model) {
  return {kind.input(effect, model), value_of(effect, gain_number),
          value_of(effect, time_constant_number)};
}

const EffectKind& kind_of(const Effect& effect) {
  if (effect.own) return *effect.own;
  if (const EffectKind* const kind = find_kind(effect.id)) return *kind;
  throw std::logic_error("there is no effect on a displacement over time with the name " +
                         effect.id);
}

const EffectCard& card_of(const Effect& effect) { return kind_of(effect).card(); }

double value_of(const Effect& effect, const record::NumberCard& number) {
  const std::span<const record::NumberCard> all = kind_of(effect).numbers(effect);
  for (std::size_t k = 0; k < std::min(all.size(), effect.values.size()); ++k)
    if (all[k].name == number.name) return effect.values[k];
  throw std::logic_error(effect.id + " has no number " + std::string(number.name));
}

}  // namespace raceway::correction
