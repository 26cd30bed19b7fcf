#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "record/record.h"
#include "record/series_channel.h"

namespace raceway::correction {

/// A record over time made of functions of the time [s], each in the unit of its column.
struct MadeRecord {
  std::vector<double> time;

  explicit MadeRecord(double duration, double step) {
    for (double t = 0.0; t <= duration + 1e-9; t += step) time.push_back(t);
    record.set(record::time, time);
  }

  MadeRecord& with(const std::string& name, const std::function<double(double)>& of) {
    const record::Channel& channel = *record::series_channel(name);
    std::vector<double> values;
    for (const double t : time) values.push_back(channel.to_SI(of(t)));
    record.set(channel, std::move(values));
    return *this;
  }

  record::Record record{.source = "made.csv"};
};

/// Steps of the speed: up, further up, rest, up [rpm], each for `length` [s].
inline double stepped_speed(double t, double length) {
  constexpr double speeds[] = {4000, 9000, 0, 6500, 2000, 0, 8000, 3000};
  return speeds[static_cast<std::size_t>(t / length) % 8];
}

}  // namespace raceway::correction
