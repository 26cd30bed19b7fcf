#include "record/levels.h"

#include <algorithm>
#include <cmath>

namespace raceway::record {

std::vector<double> level_starts(std::span<const double> values, double width) {
  std::vector<double> sorted;
  for (const double v : values)
    if (!std::isnan(v)) sorted.push_back(v);
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> starts;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (i == 0 || sorted[i] - sorted[i - 1] > width) starts.push_back(sorted[i]);
  return starts;
}

std::size_t level_of(double value, std::span<const double> starts) {
  const auto above = std::upper_bound(starts.begin(), starts.end(), value);
  return above == starts.begin() ? 0 : static_cast<std::size_t>(above - starts.begin()) - 1;
}

double step_of(const Channel& channel, std::span<const double> values) {
  if (!channel.ratio) return channel.step;
  double largest = 0.0;
  for (const double v : values) largest = std::fmax(largest, std::abs(v));
  return channel.step * largest;
}

}  // namespace raceway::record
