#include "spindle/thermometer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace raceway::spindle {
namespace {

double middle_of(const Cell& c, bool axial) {
  return axial ? 0.5 * (c.start + c.end) : c.middle_radius();
}

/// The neighbour of a cell in its body, on the side where `place` lies; -1 without.
int neighbour(const Mesh& mesh, int cell, bool axial, double place) {
  const Cell& here = mesh.cells[static_cast<std::size_t>(cell)];
  const bool up = place > middle_of(here, axial);
  for (const Touch& t : mesh.touches) {
    if (t.axial != axial || (up ? t.first : t.second) != cell) continue;
    const int other = up ? t.second : t.first;
    const Cell& there = mesh.cells[static_cast<std::size_t>(other)];
    if (there.body == here.body && there.bearing == here.bearing) return other;
  }
  return -1;
}

/// Shares of a cell and its neighbour along one direction. Between the last middle and a face the
/// slope goes on: beside a seat it is some tenths of a kelvin a millimetre.
Shares between(const Mesh& mesh, int cell, bool axial, double place) {
  const Cell& here = mesh.cells[static_cast<std::size_t>(cell)];
  const double middle = middle_of(here, axial);
  int other = neighbour(mesh, cell, axial, place);
  if (other < 0) other = neighbour(mesh, cell, axial, 2.0 * middle - place);
  if (other < 0) return {{cell, 1.0}};
  const double within = std::clamp(place, axial ? here.start : here.inner_radius,
                                   axial ? here.end : here.outer_radius);
  const double t =
      (within - middle) / (middle_of(mesh.cells[static_cast<std::size_t>(other)], axial) - middle);
  return {{cell, 1.0 - t}, {other, t}};
}

int nearest_cell(const Mesh& mesh, const model::ThermometerPlace& place) {
  using Part = model::ThermometerPlace::Part;
  if (place.part == Part::shaft) return mesh.nearest(Body::shaft, place.position, place.radius);
  if (place.part == Part::housing) return mesh.nearest(Body::housing, place.position, place.radius);
  const int inner = mesh.nearest(Body::inner_ring, place.position, place.radius);
  const int outer = mesh.nearest(Body::outer_ring, place.position, place.radius);
  if (inner < 0 || outer < 0) return std::max(inner, outer);
  const auto distance = [&](int k) {
    const Cell& c = mesh.cells[static_cast<std::size_t>(k)];
    return std::hypot(middle_of(c, true) - place.position, c.middle_radius() - place.radius);
  };
  return distance(inner) < distance(outer) ? inner : outer;
}

}  // namespace

Shares thermometer(const Mesh& mesh, const model::ThermometerPlace& place) {
  const int cell = nearest_cell(mesh, place);
  if (cell < 0)
    throw std::invalid_argument(fmt::format(
        "sensor {}: the spindle does not have the part that this sensor measures", place.name));
  std::map<int, double> sum;
  for (const Share& column : between(mesh, cell, true, place.position))
    for (const Share& row : between(mesh, column.cell, false, place.radius))
      sum[row.cell] += column.share * row.share;
  Shares shares;
  for (const auto& [k, share] : sum) shares.push_back({k, share});
  return shares;
}

}  // namespace raceway::spindle
