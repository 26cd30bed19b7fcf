#include "model/sensor_place.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raceway::model {
namespace {

/// Around `sensor` through segments that hold its radius; `bore` where one leaves it open.
std::pair<double, double> through(const std::vector<Segment>& segments, double start, double bore,
                                  const ThermometerPlace& sensor) {
  std::pair<double, double> reach{unset, unset};
  for (const Segment& s : segments) {
    const double end = start + s.length;
    const double inner = 0.5 * (std::isnan(s.bore) ? bore : s.bore);
    const bool holds = sensor.radius >= inner && sensor.radius <= 0.5 * s.diameter;
    if (!holds && reach.second >= sensor.position) return reach;
    if (!holds)
      reach = {unset, unset};
    else
      reach = {std::isnan(reach.first) ? start : reach.first, end};
    start = end;
  }
  return reach;
}

}  // namespace

std::pair<double, double> reach_of(const Model& model, const ThermometerPlace& sensor) {
  const Spindle& spindle = *model.spindle;
  std::pair<double, double> reach{unset, unset};
  switch (sensor.part) {
    case ThermometerPlace::Part::shaft:
      reach = through(spindle.shaft.segments, 0.0, 0.0, sensor);
      break;
    case ThermometerPlace::Part::housing:
      reach = through(spindle.housing.segments, spindle.housing.start,
                      model.bearing.geometry().outer_diameter, sensor);
      break;
    case ThermometerPlace::Part::ring:
      for (const auto* positions : {&spindle.front_positions, &spindle.rear_positions})
        for (const double centre : *positions)
          if (const double half = 0.5 * spindle.bearing_width;
              std::abs(sensor.position - centre) <= half)
            reach = {centre - half, centre + half};
      break;
    case ThermometerPlace::Part::coolant:
      break;
  }
  const bool holds = reach.first <= sensor.position && sensor.position <= reach.second;
  return holds ? reach : std::pair{sensor.position, sensor.position};
}

}  // namespace raceway::model
