#include "correction/step_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correction/catalogue.h"
#include "correction/numbers.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "record/median.h"

namespace raceway::correction {
namespace {

constexpr double many_rpm = 1000.0;  // a step of the speed that is felt
constexpr std::size_t most_samples = 400;

std::string words_of(const Input& input) {
  if (input.is_power()) return "power";
  std::string text;
  for (const Channel* c : input.columns) text += (text.empty() ? "" : ", ") + std::string(c->words);
  if (input.columns.size() > 1) text = "mean of " + text;
  if (input.exponent != 1.0) text += fmt::format(" to the power {:g}", input.exponent);
  if (input.reference) text += " less " + std::string(input.reference->words);
  return text;
}

/// With the step and its unit; nothing that answers yet.
StepResponse response_to(std::string name, const Input& input) {
  StepResponse r{.name = std::move(name), .input = words_of(input)};
  r.unit = input.unit();
  if (r.unit == "rpm") r.step = many_rpm;
  return r;
}

/// Of a delay element, with the power at which it is shown.
StepResponse of_element(const DrivenChannel& c, double power) {
  StepResponse r = response_to(c.name, c.input);
  r.step = power;
  r.parts = {
      {"delay element", c.scale * c.element->target(power), c.element->time_constant(power)}};
  return r;
}

/// The median above zero, and the largest that it can take.
std::vector<double> powers_shown(const DrivenChannel& c, const Series& series) {
  std::vector<double> running;
  for (const double p : *series.input(c.input))
    if (p > 0.0 && p < c.element->power_limit()) running.push_back(p);
  if (running.empty()) return {};
  const double middle = record::median(running);
  const double largest = *std::max_element(running.begin(), running.end());
  return largest > 1.05 * middle ? std::vector{middle, largest} : std::vector{largest};
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

StepResponse of_channel(const Model& model, const DrivenChannel& c, const Series& series) {
  StepResponse r = response_to(c.name, c.input);
  const double per_step = c.scale * c.input.factor() * r.step;
  for (std::size_t s = 0; s < c.sections.size(); ++s)
    r.parts.push_back({fmt::format("section {}", s + 1), per_step * c.sections[s].gain,
                       c.sections[s].time_constant});
  r.at_once = per_step * c.feedthrough;
  r.sensor_time_constant = answer_of(model, c).sensor_time_constant;
  if (c.printed) sample(c, series, r);
  for (const Effect& e : model.effects) {
    if (find_channel(model, e.where) != &c) continue;
    if (e.id == "second-time-constant")
      r.parts.push_back({full_id(e), e.values[0] * um * r.step, e.values[1]});
    else if (find_card(e.id)->of_channel && e.id != "sensor-lag")
      r.changed_by.push_back(full_id(e));
  }
  return r;
}

/// Of a share of its own that is a lag.
StepResponse of_effect(const Model& model, const Effect& e) {
  StepResponse r = response_to(full_id(e), input_of(e, model));
  if (e.id == "slow-drift" || e.columns.empty()) r.unit.clear();
  if (e.id == "slow-drift")
    r.input = "the start of the record";
  else if (e.columns.empty())
    r.input =
        fmt::format("exp(-n/{:.4g} rpm) of the motor, turning", value_of(e, "decay_speed_rpm"));
  r.parts = {{full_id(e), e.values[0] * um * r.step, e.values[1]}};
  return r;
}

}  // namespace

std::vector<StepResponse> step_responses(const Model& model, const record::Record& record) {
  const Series series(record);
  std::vector<StepResponse> list;
  for (const DrivenChannel& c : model.channels) {
    if (c.element)
      for (const double power : powers_shown(c, series)) list.push_back(of_element(c, power));
    else
      list.push_back(of_channel(model, c, series));
  }
  for (const Effect& e : model.effects)
    if (e.id == "ambient-drift" || e.id == "motor-heat" || e.id == "feed-axis-heat" ||
        e.id == "slow-drift")
      list.push_back(of_effect(model, e));
  return list;
}

}  // namespace raceway::correction
