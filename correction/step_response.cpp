#include "correction/step_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "correction/numbers.h"
#include "correction/own_effect.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "record/median.h"

namespace raceway::correction {
namespace {

constexpr double many_rpm = 1000.0;  // a step of the speed that is felt
constexpr std::size_t most_samples = 400;

std::string words_of(const Input& input) {
  if (input.is_power()) return "power";
  if (input.formula) return input.formula->given().formula;
  std::string text;
  for (const Channel* c : input.columns) text += (text.empty() ? "" : ", ") + std::string(c->words);
  if (input.columns.size() > 1) text = "mean of " + text;
  if (input.exponent != 1.0) text += fmt::format(" to the power {:g}", input.exponent);
  if (input.reference) text += " less " + std::string(input.reference->words);
  if (input.window)
    text += fmt::format(" at {} {}", input.window->column->words, input.window->range_text());
  return text;
}

/// With the step and its unit; nothing that answers yet.
StepResponse response_to(std::string name, const Input& input) {
  StepResponse r{.name = std::move(name), .input = words_of(input)};
  r.unit = input.unit();
  if (r.unit == "rpm") r.step = many_rpm;
  return r;
}

/// The median above zero, and the largest that it can take; below zero the largest by its amount.
std::vector<double> steps_shown(const DrivenChannel& c, const Series& series) {
  const Interval takes = c.element->domain();
  std::vector<double> running, shown;
  double below = 0.0;
  for (const double si : *series.input(c.input)) {
    const double x = si / c.input.factor();
    if (x >= takes.lower && x < takes.upper && x > 0.0) running.push_back(x);
    if (x >= takes.lower) below = std::min(below, x);
  }
  if (!running.empty()) {
    const double middle = record::median(running);
    shown.push_back(*std::max_element(running.begin(), running.end()));
    if (shown.front() > 1.05 * middle) shown.insert(shown.begin(), middle);
  }
  if (below < 0.0) shown.push_back(below);
  return shown;
}

/// Over half of the record, of which so many samples are kept.
void sample(const DrivenChannel& c, const Series& series, StepResponse& r) {
  double longest = 0.0;
  for (const double t : series.time()) longest = std::max(longest, t);
  const auto count = static_cast<std::size_t>(0.5 * longest / c.printed->sampling) + 2;
  const std::vector<double> all = run(*c.printed, std::vector<double>(count, 1.0));
  const std::size_t stride = std::max<std::size_t>(1, count / most_samples);
  for (std::size_t k = 0; k < count; k += stride) r.sampled.push_back(c.scale * all[k]);
  r.sampling = static_cast<double>(stride) * c.printed->sampling;
}

/// Adds what the effects at a channel add to its response or change in it. They change no element.
void add_effects(const Model& model, const DrivenChannel& c, StepResponse& r) {
  for (const Effect& e : model.effects) {
    const EffectKind& kind = kind_of(e);
    if (!kind.card().at_channel || find_channel(model, e.where) != &c) continue;
    const Share share = kind.share(e, model);
    if (const auto* const more = std::get_if<DrivenShare>(&share))
      r.parts.push_back({full_id(e), more->gain * um * r.step, more->time_constant});
    Answer changed;
    kind.change(e, model, changed);
    changed.sensor_time_constant = 0.0;  // is drawn
    if (!c.element && !changed.is_plain()) r.changed_by.push_back(full_id(e));
  }
}

/// The step response of a delay element to this power or load.
StepResponse of_element(const Model& model, const DrivenChannel& c, double step) {
  StepResponse r = response_to(c.name, c.input);
  r.step = step;
  r.parts = {{"delay element", c.scale * c.element->target(step), c.element->time_constant(step)}};
  add_effects(model, c, r);
  return r;
}

StepResponse of_channel(const Model& model, const DrivenChannel& c, const Series& series) {
  StepResponse r = response_to(c.name, c.input);
  const double per_step = c.scale * c.input.factor() * r.step;
  for (std::size_t s = 0; s < c.sections.size(); ++s)
    r.parts.push_back({fmt::format("section {}", s + 1), per_step * c.sections[s].gain,
                       c.sections[s].time_constant});
  r.at_once = per_step * c.feedthrough;
  r.sensor_time_constant = answer_of(model, c).sensor_time_constant;
  if (c.printed) sample(c, series, r);
  add_effects(model, c, r);
  return r;
}

/// Step response of a share by its kind; none for a share without a lag.
struct Responder {
  const Effect& effect;

  std::optional<StepResponse> operator()(const DrivenShare& s) const {
    if (std::isnan(s.time_constant)) return std::nullopt;
    StepResponse r = response_to(full_id(effect), s.input);
    r.parts = {{r.name, s.gain * um * r.step, s.time_constant}};
    return r;
  }
  std::optional<StepResponse> operator()(const MotorShare& s) const {
    return of_one_size(
        fmt::format("motor heat exp(-n/{:.4g} rpm) at the speed n, while the spindle turns",
                    s.decay_speed),
        s.gain, s.time_constant);
  }
  std::optional<StepResponse> operator()(const SettlingShare& s) const {
    return of_one_size("the start of the record", s.size, s.time_constant);
  }
  // These act at once.
  std::optional<StepResponse> operator()(const Kinematic&) const { return std::nullopt; }
  std::optional<StepResponse> operator()(const JumpShare&) const { return std::nullopt; }
  std::optional<StepResponse> operator()(std::monostate) const { return std::nullopt; }

 private:
  [[nodiscard]] StepResponse of_one_size(std::string input, double size,
                                         double time_constant) const {
    return {.name = full_id(effect),
            .input = std::move(input),
            .parts = {{full_id(effect), size * um, time_constant}}};
  }
};

}  // namespace

std::vector<StepResponse> step_responses(const Model& model, const record::Record& record) {
  const Series series(record);
  std::vector<StepResponse> list;
  for (const DrivenChannel& c : model.channels) {
    if (c.element)
      for (const double step : steps_shown(c, series)) list.push_back(of_element(model, c, step));
    else
      list.push_back(of_channel(model, c, series));
  }
  for (const Effect& e : model.effects) {
    if (card_of(e).at_channel) continue;  // drawn with its channel
    if (auto r = std::visit(Responder{e}, kind_of(e).share(e, model)))
      list.push_back(*std::move(r));
  }
  return list;
}

}  // namespace raceway::correction
