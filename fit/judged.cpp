#include "fit/judged.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/grid.h"
#include "record/levels.h"

namespace raceway::fit {
namespace {

constexpr int most_blocks = 8;
constexpr std::size_t few_blockings = 3;  // with fewer, runs are held out as well
constexpr int levels_of_an_axis = 5;

/// Levels of a channel, merged to at most eight ranges; no blocks where it does not vary.
Blocking blocks_of_levels(const Channel& channel, std::span<const double> values, double width) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> first = record::level_starts(sorted, width);
  if (first.size() > static_cast<std::size_t>(most_blocks) || first.size() < 2) {
    const bool many = first.size() >= 2 || sorted.back() - sorted.front() > 3.0 * width;
    first.assign(1, sorted.front());
    for (int k = 1; many && k < most_blocks; ++k) {
      const double value = sorted[sorted.size() * static_cast<std::size_t>(k) / most_blocks];
      if (value > first.back()) first.push_back(value);
    }
  }
  Blocking result{.variable = std::string(channel.variable)};
  for (const double value : values)
    result.block.push_back(static_cast<int>(record::level_of(value, first)));
  result.blocks = static_cast<int>(first.size());
  result.ordered = channel.is_input();
  return result;
}

/// Lowest and highest value; not finite where there is none.
std::pair<double, double> range_of(std::span<const double> values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values) {
    if (std::isnan(v)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  return {low, high};
}

}  // namespace

std::vector<const Channel*> Judged::scattering(const Record&) const { return {}; }

std::vector<Fault> Judged::faults(const Record&) const { return {}; }

std::string Judged::lacks(const std::string&, const Record&) const { return {}; }

std::string Judged::lacks_levels(const std::string&, const Record&) const { return {}; }

Saturation Judged::saturation(const Record& record) const {
  Saturation result;
  for (const record::Column& c : record.columns) {
    if (!c.channel->is_input() || !record.complete(*c.channel)) continue;
    const bool first = result.surface.inputs.empty();
    // On a ratio scale less than one of its unit is no variation; the first is taken as it is.
    const double least = first ? 0.0 : c.channel->ratio ? c.channel->factor : c.channel->step;
    result.surface.inputs.push_back({c.values, least});
    if (c.channel->role == record::Role::setting && c.channel->ratio)
      result.levels.push_back(c.channel);
  }
  const std::size_t count = result.surface.inputs.size();
  const auto term = [&](int power_of_first, std::size_t other, int power) {
    std::vector<int> exponents(count, 0);
    if (count > 0) exponents[0] = power_of_first;
    if (power > 0) exponents[other] = power;
    result.surface.terms.push_back(std::move(exponents));
  };
  for (int power = 0; power <= (count > 0 ? 4 : 0); ++power) term(power, 0, 0);
  for (std::size_t k = 1; k < count; ++k) {
    term(0, k, 1);
    term(0, k, 2);
    term(1, k, 1);
    term(2, k, 1);
  }
  return result;
}

std::vector<Factor> Judged::factors(const Record& record) const {
  std::vector<Factor> result;
  for (const record::Column& c : record.columns)
    if (c.channel->is_input() && record.complete(*c.channel))
      result.push_back({std::string(c.channel->words), c.values});
  return result;
}

std::optional<Formula> Judged::formula(const Record&) const { return std::nullopt; }

std::vector<Blocking> Judged::blockings(const Record& record) const {
  std::vector<Blocking> result;
  const auto add = [&](const Channel& channel, double width) {
    const std::span<const double> values = record.values(channel);
    if (values.empty()) return;
    // A cell that was not read is a level of its own.
    std::vector<double> filled(values.begin(), values.end());
    for (double& v : filled) v = std::isnan(v) ? 0.0 : v;
    Blocking blocking = blocks_of_levels(channel, filled, width);
    if (blocking.blocks >= 2) result.push_back(std::move(blocking));
  };
  for (const record::Column& c : record.columns)
    if (c.channel->is_input())
      // A temperature wanders by a step where it was meant to stand still.
      add(*c.channel,
          c.channel->ratio ? record::step_of(*c.channel, c.values) : 2.0 * c.channel->step);
  if (result.size() < few_blockings) add(record::run, record::run.step);
  return result;
}

std::string Judged::doubt(const Record&, std::span<const double>) const { return {}; }

std::vector<Axis> Judged::axes(const Record& record) const {
  std::vector<Axis> result;
  for (const record::Column& c : record.columns) {
    if (c.channel->role != record::Role::setting) continue;
    const auto [low, high] = range_of(c.values);
    if (std::isfinite(low) && std::isfinite(high))
      result.push_back({c.channel, grid(low, high, levels_of_an_axis), record.varies(*c.channel)});
  }
  return result;
}

std::string Judged::words(std::span<const Setting> point) const {
  std::vector<std::string> texts;
  for (const Setting& s : point)
    if (std::isfinite(s.value))
      texts.push_back(fmt::format("{:.4g} {}", s.channel->in_unit(s.value), s.channel->unit));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::vector<std::string> Judged::records_needed(const Record&,
                                                const std::vector<std::vector<std::string>>&,
                                                const std::vector<std::string>&) const {
  return {};
}

}  // namespace raceway::fit
