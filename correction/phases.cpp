#include "correction/phases.h"

#include <algorithm>
#include <cmath>

namespace raceway::correction {
namespace {

constexpr double soon = 900.0;  // after a change [s]
constexpr double half_an_hour = 1800.0;
constexpr double moves = 0.05;  // of the span of the readings, in half an hour

}  // namespace

std::vector<std::string> phases(const record::Record& record, const record::Channel& displacement) {
  const std::span<const double> time = record.values(record::time),
                                speed = record.values(record::speed),
                                read = record.values(displacement);
  std::vector<std::string> result(record.rows());
  if (time.empty() || read.empty()) return result;
  double low = unset, high = unset;
  for (const double v : read) low = std::fmin(low, v), high = std::fmax(high, v);
  double changed = -2.0 * soon, begin = 0.0;
  std::size_t first = 0;
  for (std::size_t k = 0; k < record.rows(); ++k) {
    const bool begins = k == 0 || record.run_of(k) != record.run_of(k - 1);
    if (begins) {
      changed = time[k] - 2.0 * soon;
      begin = time[k];
      first = k;
    } else if (!speed.empty() && speed[k] != speed[k - 1]) {
      changed = time[k];
    }
    while (time[first] < std::max(begin, time[k] - half_an_hour)) ++first;
    double slope = 0.0;
    if (std::isfinite(read[k]) && std::isfinite(read[first])) slope = read[k] - read[first];
    if (time[k] - changed < soon)
      result[k] = "after a change of speed";
    else if (std::abs(slope) > moves * (high - low))
      result[k] = slope > 0.0 ? "rising" : "falling";
    else if (!speed.empty() && speed[k] == 0.0)
      result[k] = "at rest";
    else
      result[k] = "steady";
  }
  return result;
}

}  // namespace raceway::correction
