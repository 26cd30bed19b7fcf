#include "verdict/hidden_input.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "fit/distributions.h"
#include "record/repeats.h"

namespace raceway::verdict {

namespace {

constexpr record::SamePoint nearly_equal{.relative = 0.02, .temperature = 1.0};
constexpr int fewest_degrees = 8;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// How much of the deviations goes with the runs, and how easily it would by chance.
void ask_the_runs(const std::map<int, std::vector<double>>& runs, int degrees, HiddenInput& found) {
  double total = 0.0, between = 0.0;
  for (const auto& [run, deviations] : runs) {
    double sum = 0.0;
    for (const double d : deviations) {
      sum += d;
      total += d * d;
    }
    between += sum * sum / static_cast<double>(deviations.size());
  }
  const int runs_degrees = static_cast<int>(runs.size()) - 1;
  const int rest = degrees - runs_degrees;
  if (runs_degrees < 1 || rest < 1 || !(total > 0.0)) return;
  found.run_share = std::min(1.0, between / total);
  const double statistic = found.run_share / runs_degrees * rest / (1.0 - found.run_share);
  found.run_p_value = std::isfinite(statistic) ? fit::f_above(runs_degrees, rest, statistic) : 0.0;
}

}  // namespace

std::optional<HiddenInput> find_hidden_input(const record::Record& record,
                                             const fit::Measured& measured) {
  if (std::isnan(measured.most_scatter)) return std::nullopt;
  const std::span<const double> readings = record.values(*measured.channel);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (std::isnan(readings[i])) continue;
    if (std::isfinite(record.value(record::time, i)) || !(readings[i] > 0.0)) return std::nullopt;
    rows.push_back(i);
  }
  if (rows.empty()) return std::nullopt;
  HiddenInput found{.channel = measured.channel};
  std::vector<double> sizes;
  std::map<int, std::vector<double>> runs;
  int degrees = 0;
  double square = 0.0, widest = 0.0;
  for (const record::RepeatGroup& group : record::find_repeats(record, nearly_equal, rows)) {
    std::vector<double> logarithms;
    double mean = 0.0;
    for (const std::size_t i : group) {
      logarithms.push_back(std::log(readings[i]));
      mean += logarithms.back();
    }
    const auto count = static_cast<double>(group.size());
    mean /= count;
    const double middle = median(logarithms);
    degrees += static_cast<int>(group.size()) - 1;
    for (std::size_t k = 0; k < group.size(); ++k) {
      const double deviation = logarithms[k] - mean;
      square += deviation * deviation;
      // The middle of few rows takes part of their deviations with it.
      sizes.push_back(std::sqrt(count / (count - 1.0)) * std::abs(logarithms[k] - middle));
      const int run = record.run_of(group[k]);
      if (run >= 0) runs[run].push_back(deviation);
    }
    const auto [low, high] = std::minmax_element(logarithms.begin(), logarithms.end());
    if (*high - *low > widest) {
      widest = *high - *low;
      found.low = group[static_cast<std::size_t>(low - logarithms.begin())];
      found.high = group[static_cast<std::size_t>(high - logarithms.begin())];
    }
  }
  if (degrees < fewest_degrees) return std::nullopt;
  found.scatter = std::min(std::sqrt(square / degrees), 1.4826 * median(sizes));
  if (!(found.scatter > measured.most_scatter)) return std::nullopt;
  ask_the_runs(runs, degrees, found);
  return found;
}

}  // namespace raceway::verdict
