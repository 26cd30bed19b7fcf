#include "spindle/stress.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "spindle/part_stress.h"

namespace raceway::spindle {
namespace {

/// Returns the temperatures of one part from bore to surface. `cells` is one column, innermost
/// first.
std::vector<RadialTemperature> profile_of(std::span<const Cell> cells, std::size_t first,
                                          const Vector& temperatures, const CylinderHeat& heat) {
  const auto at = [&](std::size_t k) { return static_cast<Eigen::Index>(first + k); };
  const std::size_t last = cells.size() - 1;
  const double inside = temperatures[at(0)], outside = temperatures[at(last)];
  const Cell& inner = cells.front();
  std::vector<RadialTemperature> profile;
  profile.push_back(
      {inner.inner_radius, inner.inner_radius > 0.0
                               ? inside - heat.inner[at(0)] * inner.inner_half_resistance()
                               : inside});
  for (std::size_t k = 0; k < cells.size(); ++k)
    profile.push_back({cells[k].middle_radius(), temperatures[at(k)]});
  profile.push_back({cells.back().outer_radius,
                     outside - heat.outer[at(last)] * cells.back().outer_half_resistance()});
  return profile;
}

}  // namespace

const Stress& SectionStress::largest() const {
  return *std::max_element(at.begin(), at.end(), [](const Stress& a, const Stress& b) {
    return a.von_mises() < b.von_mises();
  });
}

std::vector<SectionStress> stresses(const ThermalSystem& system, const Vector& temperatures,
                                    const Vector& raceways, double speed) {
  const Layout& layout = system.layout();
  const std::vector<Cell>& cells = layout.mesh.cells;
  CylinderHeat heat = system.through_cylinders(temperatures);
  std::vector<int> seat_of(cells.size(), -1);  // bearing whose seat a cell of the shaft carries
  for (std::size_t b = 0; b < layout.bearings.size(); ++b)
    for (const Joint& j : layout.bearings[b].inner_seat)
      for (const int k : {j.first, j.second})
        if (cells[static_cast<std::size_t>(k)].body == Body::shaft)
          seat_of[static_cast<std::size_t>(k)] = static_cast<int>(b);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (cells[k].body == Body::inner_ring) heat.outer[i] -= raceways[i];
    if (cells[k].body == Body::outer_ring) heat.inner[i] -= raceways[i];
  }
  const auto pressure = [](const SeatState& seat) {
    return seat.pressure > 0.0 ? seat.pressure : 0.0;
  };
  std::vector<SectionStress> list;
  for (std::size_t first = 0, next; first < cells.size(); first = next) {
    const Cell& cell = cells[first];
    next = first + 1;
    while (next < cells.size() && cells[next].region == cell.region &&
           cells[next].column == cell.column)
      ++next;
    if (cell.body == Body::spacer || cell.body == Body::housing) continue;
    RoundPart part{.material = cell.material,
                   .profile = profile_of(std::span(cells).subspan(first, next - first), first,
                                         temperatures, heat)};
    SectionStress section{.start = cell.start, .end = cell.end};
    section.bearing = cell.body == Body::shaft ? seat_of[next - 1] : cell.bearing;
    const SeatsOfBearing seats = section.bearing < 0
                                     ? SeatsOfBearing{}
                                     : system.seats()[static_cast<std::size_t>(section.bearing)];
    if (cell.body == Body::outer_ring) {
      section.part = SectionStress::Part::outer_ring;
      part.surface_pressure = pressure(seats.outer);
    } else {
      section.part =
          cell.body == Body::shaft ? SectionStress::Part::shaft : SectionStress::Part::inner_ring;
      (cell.body == Body::shaft ? part.surface_pressure : part.bore_pressure) =
          pressure(seats.inner);
      part.speed = speed;
    }
    section.at = stresses_of(part);
    list.push_back(std::move(section));
  }
  return list;
}

}  // namespace raceway::spindle
