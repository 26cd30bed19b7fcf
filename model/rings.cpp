#include "model/rings.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace raceway::model {

std::vector<Rings> rings_of(const Spindle& s, const bearing::Arrangement& sets) {
  std::vector<double> positions = s.front_positions;
  positions.insert(positions.end(), s.rear_positions.begin(), s.rear_positions.end());
  const auto bearings = sets.bearings();
  if (positions.size() != bearings.size())
    throw std::invalid_argument(
        fmt::format("the arrangement has {} bearings, but {} positions are given", bearings.size(),
                    positions.size()));
  std::vector<Rings> all;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const bearing::BearingGeometry& g = bearings[k].bearing->geometry();
    all.push_back({.position = positions[k],
                   .width = s.bearing_width,
                   .bore = g.bore,
                   .outer_diameter = g.outer_diameter,
                   .inner_shoulder = s.inner_ring_shoulder,
                   .outer_shoulder = s.outer_ring_shoulder,
                   .inner_interference = s.seat.inner_interference,
                   .outer_clearance = s.seat.outer_clearance});
  }
  const auto or_seat = [](double own, double of_seat) { return std::isnan(own) ? of_seat : own; };
  for (const RollerOnShaft& r : s.rollers) {
    const bearing::RollerGeometry& g = r.bearing.geometry();
    all.push_back({.position = r.position,
                   .width = g.width,
                   .bore = g.bore,
                   .outer_diameter = g.outer_diameter,
                   .inner_shoulder = g.raceway_diameter(bearing::Race::inner),
                   .outer_shoulder = g.raceway_diameter(bearing::Race::outer),
                   .inner_interference = or_seat(r.inner_interference, s.seat.inner_interference),
                   .outer_clearance = or_seat(r.outer_clearance, s.seat.outer_clearance)});
  }
  return all;
}

std::vector<std::string> bearing_names(std::size_t front, std::size_t rear,
                                       std::span<const RollerOnShaft> rollers) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < front; ++k) names.push_back(fmt::format("front_{}", k + 1));
  for (std::size_t k = 0; k < rear; ++k) names.push_back(fmt::format("rear_{}", k + 1));
  for (const RollerOnShaft& roller : rollers) names.push_back(roller.name);
  return names;
}

}  // namespace raceway::model
