#include "correction/effects/sensor_quantisation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>

#include "correction/quantum.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

/// True if an error of this size makes up much of the residual. A feedthrough of an input in steps
/// is found a third too small [errors in variables], and its error with it.
bool explains(double rms, std::span<const double> left) {
  constexpr double much_of_it = 0.4;  // of the mean square
  double sum = 0.0, square = 0.0, count = 0.0;
  for (const double r : left)
    if (std::isfinite(r)) {
      sum += r;
      square += r * r;
      count += 1.0;
    }
  return rms * rms * count >= much_of_it * (square - sum * sum / count);
}

/// True if the residual steps back wherever the input steps, by the step that the feedthrough made.
bool steps_with(const std::vector<double>& input, std::span<const double> left, double feedthrough,
                const std::vector<bool>& begins) {
  constexpr double surely = 8.0;  // standard errors
  constexpr double least = 0.4;   // of the feedthrough
  constexpr double fewest = 30.0;
  double sum = 0.0, square = 0.0, count = 0.0;
  for (std::size_t k = 1; k < input.size(); ++k) {
    const double step = input[k] - input[k - 1], back = (left[k - 1] - left[k]) / step;
    if (begins[k] || step == 0.0 || !std::isfinite(back)) continue;
    sum += back / feedthrough;
    square += std::pow(back / feedthrough, 2);
    count += 1.0;
  }
  if (count < fewest) return false;
  const double mean = sum / count, variance = square / count - mean * mean;
  return mean > least && mean > surely * std::sqrt(variance / count);
}

}  // namespace

std::vector<fit::Fault> SensorQuantisation::faults(const FittedRecord& in) const {
  const record::Record& record = in.series.record();
  const std::vector<bool>& begins = in.series.clock().begins;
  std::vector<fit::Fault> list;
  for (const DrivenChannel& c : in.model.channels) {
    if (c.feedthrough == 0.0 || c.input.is_power()) continue;
    auto without = std::make_shared<record::Record>(record);
    std::vector<std::string> sensors;
    double largest = 0.0, square = 0.0;
    const auto smooth = [&](const Channel& column, double weight) {
      if (record::course_of(column) != record::Course::straight) return;
      const std::span<const double> values = record.values(column);
      const double quantum = quantum_of(column, values);
      if (std::isnan(quantum)) return;
      sensors.emplace_back(column.name);
      largest = std::max(largest, quantum);
      square += std::pow(weight * quantum, 2) / 12.0;  // of what is evenly spread over a quantum
      without->find(column)->values = between_digits(record.values(record::time), values, begins);
    };
    for (const Channel* column : c.input.columns)
      smooth(*column, 1.0 / static_cast<double>(c.input.columns.size()));
    if (c.input.reference) smooth(*c.input.reference, 1.0);
    const double moved = c.scale * c.feedthrough * std::sqrt(square);
    if (sensors.empty() || !explains(moved, in.left) ||
        !steps_with(*in.series.input(c.input), in.left, c.scale * c.feedthrough, begins))
      continue;
    list.push_back(
        {.id = std::string(quantisation_card.id),
         .datum = fmt::format("the sensor of {}", fmt::join(sensors, ", ")),
         .correction = fmt::format("its resolution is {:.3g} K, and the feedthrough of channel {} "
                                   "passes each temperature step to the predicted displacement",
                                   largest, c.name),
         .without = std::move(without)});
  }
  return list;
}

}  // namespace raceway::correction
