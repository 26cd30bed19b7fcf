#include "correction/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "correction/effect_kind.h"
#include "correction/own_effect.h"
#include "record/nearest_names.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr std::array<std::string_view, 5> groups{"gains", "time_constants", "offset", "kinematic",
                                                 "scale"};

class List {
 public:
  List(Model& model, const TimeConstantLimits& limits) : model_(model), limits_(limits) {}

  std::vector<Number> numbers() {
    add("offset", "um", "correction.offset_um", "offset", model_.offset, um).proportional = true;
    for (std::size_t c = 0; c < model_.channels.size(); ++c) add_channel(c);
    if (model_.kinematic) add_kinematic(*model_.kinematic);
    for (std::size_t e = 0; e < model_.effects.size(); ++e) add_effect(e);
    for (Number& n : list_)
      for (const NumberPrior& p : model_.priors)
        if (p.name == n.parameter.name) n.parameter.prior = p.prior;
    return std::move(list_);
  }

 private:
  /// Unit and address are written for a length.
  record::Parameter& add(std::string name, const std::string& unit, const std::string& address,
                         std::string group, double& place, double factor) {
    Number& n = list_.emplace_back();
    n.parameter.name = std::move(name);
    n.parameter.unit = in_unit_of(model_, unit);
    n.parameter.addresses = {in_unit_of(model_, address)};
    n.parameter.start = n.parameter.value = n.parameter.initial = place / factor;
    n.parameter.lower = -endless;
    n.parameter.upper = endless;
    n.parameter.plausible_lower = -endless;
    n.parameter.plausible_upper = endless;
    n.group = std::move(group);
    n.place = &place;
    n.factor = factor;
    return n.parameter;
  }

  void bound(record::Parameter& p, double lower, double upper) const {
    p.lower = p.plausible_lower = lower;
    p.upper = p.plausible_upper = upper;
    p.scale = record::typical_size(p.start, p.initial, lower, upper);
  }

  void add_channel(std::size_t index) {
    DrivenChannel& c = model_.channels[index];
    const std::string key = fmt::format("correction.channel.{}.", index);
    const std::string gain = "um/" + std::string(c.input.unit());
    const double factor = um / c.input.factor();
    for (std::size_t s = 0; s < c.sections.size(); ++s) {
      const std::string of = fmt::format("{}sections.{}.", key, s);
      add(fmt::format("{}.gain_{}", c.name, s + 1), gain,
          fmt::format("{}gain_um_{}", of, c.input.key_unit()), "gains", c.sections[s].gain, factor)
          .proportional = true;
      bound(add(fmt::format("{}.time_constant_{}", c.name, s + 1), "s", of + "time_constant_s",
                "time_constants", c.sections[s].time_constant, 1.0),
            shortest_time_constant(c.input, limits_), limits_.longest);
    }
    if (c.feedthrough != 0.0 || (c.sections.empty() && !c.element && !c.printed))
      add(c.name + ".feedthrough", gain,
          fmt::format("{}feedthrough_um_{}", key, c.input.key_unit()), "gains", c.feedthrough,
          factor)
          .proportional = true;
    add(c.name + ".scale", "1", key + "scale", "scale", c.scale, 1.0).proportional = true;
  }

  void add_kinematic(Kinematic& law) {
    add("kinematic.A", "um", "correction.kinematic.A", "kinematic", law.A, 1.0).proportional = true;
    bound(add("kinematic.B", "1", "correction.kinematic.B", "kinematic", law.B, 1.0), 0.0, 1.2);
    bound(add("kinematic.C", "1/rpm", "correction.kinematic.C", "kinematic", law.C, 1.0), 1e-4,
          3e-3);
  }

  void add_effect(std::size_t index) {
    Effect& e = model_.effects[index];
    const EffectKind& kind = kind_of(e);
    const std::span<const record::NumberCard> cards = kind.numbers(e);
    for (std::size_t k = 0; k < e.values.size(); ++k) {
      const record::NumberCard& n = cards[k];
      record::Parameter& p =
          add(full_id(e) + "." + std::string(n.name), unit_of(e, k, model_),
              fmt::format("correction.effect.{}.{}", index, key_of(e, k, model_)), "effects",
              e.values[k], 1.0);
      p.initial = n.initial;
      p.neutral = n.neutral;
      p.proportional = kind.is_proportional(k);
      const Interval within = kind.bounds(e, k, model_, limits_);
      bound(p, within.lower, within.upper);
      if (!std::isfinite(n.lower)) p.scale = 1.0;
    }
  }

  Model& model_;
  TimeConstantLimits limits_;
  std::vector<Number> list_;
};

}  // namespace

double Window::operator()(double position) const {
  const auto& [from, full_from, full_to, to] = points;
  if (!(position >= from && position <= to)) return 0.0;
  if (position < full_from) return (position - from) / (full_from - from);
  return position > full_to ? (to - position) / (to - full_to) : 1.0;
}

std::string Window::range_text() const {
  const auto edge = [&](double p) {
    return std::isinf(p) ? std::string() : fmt::format("{:.6g}", column->in_unit(p));
  };
  const auto& [from, full_from, full_to, to] = points;
  if (from == full_from && full_to == to) return edge(from) + ".." + edge(to);
  std::vector<std::string> edges;
  for (const double p : points) edges.push_back(edge(p));
  return fmt::format("{}", fmt::join(edges, ".."));
}

std::string_view Input::unit() const {
  if (formula) return "1";
  if (is_power()) return "W";
  return columns.empty() || record::is_temperature(*columns.front()) ? "K" : columns.front()->unit;
}

std::string_view Input::key_unit() const {
  if (formula) return "";
  if (is_power()) return "W";
  return columns.empty() || record::is_temperature(*columns.front()) ? "K"
                                                                     : columns.front()->key_unit();
}

double Input::factor() const {
  return is_power() || columns.empty() ? 1.0 : columns.front()->factor;
}

record::Course Input::course() const {
  if (formula)
    return formula->follows_a_temperature() ? record::Course::straight : record::Course::held;
  return is_power() || columns.empty() ? record::Course::held : record::course_of(*columns.front());
}

std::vector<Number> numbers(Model& model, const TimeConstantLimits& limits) {
  return List(model, limits).numbers();
}

std::vector<record::Parameter> parameters(const Model& model, const TimeConstantLimits& limits) {
  Model copy = model;
  std::vector<record::Parameter> list;
  for (Number& n : numbers(copy, limits)) list.push_back(std::move(n.parameter));
  return list;
}

std::vector<std::string> free_names(const Model& model) {
  Model copy = model;
  const std::vector<Number> all = numbers(copy);
  std::vector<std::string> wanted = model.free;
  if (wanted.empty()) {
    wanted = {"gains", "time_constants", "offset", "kinematic", "effects"};
    for (const NumberPrior& p : model.priors) wanted.push_back(p.name);
  }
  std::vector<std::string> known(groups.begin(), groups.end());
  for (const Number& n : all) known.push_back(n.parameter.name);
  known.emplace_back("effects");
  for (const std::string& name : wanted)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw std::invalid_argument(
          fmt::format("no parameter and no group of parameters is called {}; nearest: {}", name,
                      record::nearest_names(name, known, 3)));
  std::vector<std::string> waiting;  // parameters of effects that are off
  for (const Effect& e : model.effects)
    if (e.off) waiting.push_back(full_id(e) + ".");
  const auto waits = [&](const std::string& name) {
    return std::any_of(waiting.begin(), waiting.end(),
                       [&](const std::string& of) { return name.starts_with(of); });
  };
  std::vector<std::string> free;
  for (const Number& n : all)
    if (waits(n.parameter.name))
      continue;
    else if (std::find(wanted.begin(), wanted.end(), n.parameter.name) != wanted.end() ||
             std::find(wanted.begin(), wanted.end(), n.group) != wanted.end())
      free.push_back(n.parameter.name);
  return free;
}

bool is_group(std::string_view name) {
  return name == "effects" || std::find(groups.begin(), groups.end(), name) != groups.end();
}

TimeConstantLimits time_constants_of(const Series& series) {
  const double sampling = series.sampling(), duration = series.duration();
  if (!(sampling > 0.0)) return {};
  return {.shortest = 2.0 * sampling, .longest = 0.5 * duration, .record = duration};
}

const DrivenChannel* find_channel(const Model& model, std::string_view name) {
  for (const DrivenChannel& c : model.channels)
    if (name.empty() || c.name == name) return &c;
  return nullptr;
}

Input input_of(const Effect& effect, const Model& model) {
  return kind_of(effect).input(effect, model);
}

double shortest_time_constant(const Input& input, const TimeConstantLimits& limits) {
  constexpr double of_a_body = 180.0;  // [s]
  return input.course() == record::Course::held ? std::max(of_a_body, limits.shortest)
                                                : limits.shortest;
}

std::string full_id(const Effect& effect) {
  if (effect.window)
    return fmt::format("{}:{}:{}{}", effect.id, effect.window->column->name,
                       effect.window->range_text(), effect.where.empty() ? "" : ":" + effect.where);
  if (card_of(effect).by_column)
    return fmt::format("{}:{}", effect.id, effect.columns.front()->name);
  return effect.where.empty() ? effect.id : effect.id + ":" + effect.where;
}

}  // namespace raceway::correction
