#include "correction/detail/learnt_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "correction/effect_kind.h"
#include "correction/numbers.h"
#include "correction/simulation.h"

namespace raceway::correction {
namespace {

constexpr double one_hour = 3600.0;
constexpr double shortest_memory = 0.5 * one_hour;
constexpr double longest_memory = 24.0 * one_hour;
constexpr double one_memory = 1.5;       // ratio below which two time constants are one
constexpr double size_of_misfits = 0.2;  // of all of them together, over the misfit
constexpr double size_of_drift = 0.5;    // in an hour, over the misfit
constexpr double memory_of_drift = 12.0 * one_hour;
constexpr double unknown_zero = 1000.0 * um;
constexpr double unknown_start = 30.0 * um;  // of sections of a machine that began warm
/// Lags that a model may lack, and what all of them may add at half the range of their inputs,
/// over the misfit.
constexpr std::array lacking{0.5 * one_hour, 2.0 * one_hour, 8.0 * one_hour};
constexpr double size_of_lacking = 2.0;
constexpr double bound_of_lacking = 5.0;  // standard deviations
constexpr double worth_saving = 0.01;     // of the misfit

/// Half of what an input did when the model was identified, SI and as it counts; NaN where that is
/// not known.
double half_range(const Model& model, const DrivenChannel& channel) {
  const Channel* const column =
      channel.input.columns.empty() ? nullptr : channel.input.columns.front();
  const auto as_it_counts = [&](double v) {
    const double e = channel.input.exponent;
    return e == 1.0 ? v : v * std::pow(std::abs(v) / (1000.0 * rpm), e - 1.0);
  };
  for (const SeenRange& r : model.range)
    if (column ? r.column == column : !r.column && r.name == channel.name)
      return r.upper > r.lower ? 0.5 * (as_it_counts(r.upper) - as_it_counts(r.lower)) : unset;
  return unset;
}

/// Whether the size of a part is a number of the machine, not of one record.
bool is_of_the_machine(const Model& model, const std::string& part) {
  for (const Effect& e : model.effects)
    if (full_id(e) == part) return !card_of(e).of_reading;
  return true;
}

std::vector<LearntPart> gains(const Model& model, const Series& series,
                              const LearningOptions& options) {
  std::vector<LearntPart> list;
  for (Contribution& c : contributions(model, series)) {
    if (!is_of_the_machine(model, c.name)) continue;
    list.push_back({.unknown = {.name = c.name,
                                .std = options.gain_std,
                                .memory = options.forgetting,
                                .bound = options.gain_bound},
                    .weights = std::move(c.displacement),
                    .name = c.name});
  }
  return list;
}

/// To the section of that time constant, where there is one from learning before.
void add_lag(DrivenChannel& channel, const Section& lag) {
  for (Section& s : channel.sections)
    if (s.time_constant == lag.time_constant) {
      s.gain += lag.gain;
      return;
    }
  channel.sections.push_back(lag);
}

}  // namespace

std::vector<LearntPart> learnt_parts(const Model& model, const Series& series,
                                     const LearningOptions& options, double misfit) {
  std::vector<LearntPart> list = gains(model, series, options);
  const std::size_t first = list.size();
  for (const DrivenChannel& c : model.channels) {
    const double half = half_range(model, c);
    if (c.sections.empty() || std::isnan(half)) continue;
    for (const double time_constant : lacking) {
      LearntPart part{
          .unknown = {.name = fmt::format("{}, lag of {:g} h", c.name, time_constant / one_hour),
                      .memory = options.forgetting},
          .weights = *series.lag(c.input, time_constant, answer_of(model, c)),
          .name = c.name,
          .is_lag = true,
          .time_constant = time_constant,
          .gain = 1.0 / half};
      for (double& w : part.weights) w *= part.gain;
      list.push_back(std::move(part));
    }
  }
  const double size =
      size_of_lacking * misfit / std::sqrt(static_cast<double>(list.size() - first));
  for (std::size_t k = first; k < list.size(); ++k) {
    list[k].unknown.std = size;
    list[k].unknown.bound = bound_of_lacking * size;
  }
  return list;
}

std::vector<Unknown> zero_and_misfits(const Model& model, double misfit) {
  std::vector<double> slow;
  for (const DrivenChannel& c : model.channels)
    for (const Section& s : c.sections) slow.push_back(std::min(s.time_constant, longest_memory));
  std::sort(slow.begin(), slow.end());
  std::vector<double> memories{shortest_memory};
  for (const double t : slow)
    if (t > one_memory * memories.back()) memories.push_back(t);
  std::vector<Unknown> list{
      {.name = "zero", .std = unknown_zero, .walk = misfit / std::sqrt(one_hour)},
      {.name = "drift",
       .std = size_of_drift * misfit / one_hour,
       .memory = memory_of_drift,
       .rate_of = 0}};
  const double size = size_of_misfits * misfit / std::sqrt(static_cast<double>(memories.size()));
  const bool warm = model.initial_state == InitialState::free;
  for (const double memory : memories)
    list.push_back({.name = fmt::format("misfit with a correlation time of {:.3g} s", memory),
                    .std = size,
                    .memory = memory,
                    .first_std = warm && memory > shortest_memory ? unknown_start : size});
  return list;
}

Model with_learnt(const Model& model, const std::vector<LearntPart>& parts,
                  const std::vector<double>& values, double zero, double misfit) {
  Model m = model;
  m.offset += zero;
  // They are of the numbers before.
  m.covariance.reset();
  m.left.reset();
  m.evidence.reset();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double value = values[k];
    for (DrivenChannel& c : m.channels) {
      if (c.name != parts[k].name) continue;
      if (!parts[k].is_lag)
        c.scale *= 1.0 + value;
      else if (std::abs(value) > worth_saving * misfit && c.scale != 0.0)
        add_lag(c, {value * parts[k].gain / c.scale, parts[k].time_constant});
    }
    if (parts[k].is_lag) continue;
    if (m.kinematic && parts[k].name == "kinematic") m.kinematic->A *= 1.0 + value;
    for (Effect& e : m.effects)
      if (full_id(e) == parts[k].name) e.values.front() *= 1.0 + value;
  }
  return m;
}

}  // namespace raceway::correction
