#include "spindle/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace raceway::spindle {
namespace {

constexpr double pi = std::numbers::pi;
/// Lines closer than this are one.
constexpr double line_width = 1e-7;

/// Rising, each once, with as many between two as keep them closer than `step`.
std::vector<double> grid_lines(std::vector<double> edges, double step) {
  std::sort(edges.begin(), edges.end());
  std::vector<double> lines;
  for (const double edge : edges) {
    if (lines.empty()) {
      lines.push_back(edge);
      continue;
    }
    const double last = lines.back(), width = edge - last;
    if (width < line_width) continue;
    const int parts = std::max(1, static_cast<int>(std::ceil(width / step - 1e-9)));
    for (int k = 1; k < parts; ++k) lines.push_back(last + width * k / parts);
    lines.push_back(edge);
  }
  return lines;
}

bool inside(double low, double high, double middle) { return low < middle && middle < high; }

double radial_resistance(double from, double to, double conductivity, double length) {
  return std::log(to / from) / (2.0 * pi * conductivity * length);
}

double ring_area(double inner, double outer) { return pi * (outer * outer - inner * inner); }

void validate_region(const Region& r) {
  if (!(r.end > r.start) || !(r.outer_radius > r.inner_radius) || !(r.inner_radius >= 0.0) ||
      !std::isfinite(r.end - r.start) || !std::isfinite(r.outer_radius))
    throw std::invalid_argument(fmt::format(
        "a part from {:.6g} to {:.6g} mm with diameters {:.6g} and {:.6g} mm has no "
        "volume",
        r.start / mm, r.end / mm, 2.0 * r.inner_radius / mm, 2.0 * r.outer_radius / mm));
}

/// Cells by their place in the grid.
class Grid {
 public:
  Grid(std::vector<double> z, std::vector<double> r)
      : z_(std::move(z)), r_(std::move(r)), cell_((z_.size() - 1) * (r_.size() - 1), -1) {}

  [[nodiscard]] int columns() const { return static_cast<int>(z_.size()) - 1; }
  [[nodiscard]] int rows() const { return static_cast<int>(r_.size()) - 1; }
  [[nodiscard]] double z(int k) const { return z_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] double r(int k) const { return r_[static_cast<std::size_t>(k)]; }
  /// -1 where there is none, also beyond the edges.
  [[nodiscard]] int at(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns() || row >= rows()) return -1;
    return cell_[place(column, row)];
  }
  void set(int column, int row, int cell) { cell_[place(column, row)] = cell; }

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(column) * (r_.size() - 1) + static_cast<std::size_t>(row);
  }
  std::vector<double> z_, r_;
  std::vector<int> cell_;
};

void add_faces(const Grid& grid, Mesh& mesh) {
  for (int k = 0; k < static_cast<int>(mesh.cells.size()); ++k) {
    const Cell& c = mesh.cells[static_cast<std::size_t>(k)];
    const double across = ring_area(c.inner_radius, c.outer_radius);
    const double axial = c.half_axial_resistance();
    const auto cell = [&](int index) -> const Cell& {
      return mesh.cells[static_cast<std::size_t>(index)];
    };
    using FaceSide = OpenFace::Side;
    if (grid.at(c.column - 1, c.row) < 0) mesh.open.push_back({k, FaceSide::front, across, axial});
    if (const int next = grid.at(c.column + 1, c.row); next >= 0)
      mesh.touches.push_back({k, next, true, across, axial, cell(next).half_axial_resistance()});
    else
      mesh.open.push_back({k, FaceSide::rear, across, axial});
    const double inner = 2.0 * pi * c.inner_radius * c.length();
    const double outer = 2.0 * pi * c.outer_radius * c.length();
    if (c.inner_radius > 0.0 && grid.at(c.column, c.row - 1) < 0)
      mesh.open.push_back({k, FaceSide::inner, inner, c.inner_half_resistance()});
    if (const int next = grid.at(c.column, c.row + 1); next >= 0)
      mesh.touches.push_back(
          {k, next, false, outer, c.outer_half_resistance(), cell(next).inner_half_resistance()});
    else
      mesh.open.push_back({k, FaceSide::outer, outer, c.outer_half_resistance()});
  }
}

}  // namespace

double Cell::section() const { return solid_share * ring_area(inner_radius, outer_radius); }

double Cell::heat_capacity() const {
  return section() * length() * material.density * material.heat_capacity;
}

double Cell::half_axial_resistance() const {
  return 0.5 * length() / (material.conductivity * section());
}

double Cell::inner_half_resistance() const {
  if (!(inner_radius > 0.0)) return std::numeric_limits<double>::infinity();
  return radial_resistance(inner_radius, middle_radius(), solid_share * material.conductivity,
                           length());
}

double Cell::outer_half_resistance() const {
  return radial_resistance(middle_radius(), outer_radius, solid_share * material.conductivity,
                           length());
}

int Mesh::nearest(Body body, double position, double radius) const {
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  const auto beyond = [](double low, double high, double x) {
    return std::max({0.0, low - x, x - high});
  };
  for (int k = 0; k < static_cast<int>(cells.size()); ++k) {
    const Cell& c = cells[static_cast<std::size_t>(k)];
    if (c.body != body) continue;
    const double distance = std::hypot(beyond(c.start, c.end, position),
                                       beyond(c.inner_radius, c.outer_radius, radius));
    if (distance < least) {
      least = distance;
      found = k;
    }
  }
  return found;
}

Mesh make_mesh(std::span<const Region> regions, double axial, double radial,
               std::span<const double> lines) {
  std::vector<double> z(lines.begin(), lines.end()), r;
  for (const Region& region : regions) {
    validate_region(region);
    z.insert(z.end(), {region.start, region.end});
    r.insert(r.end(), {region.inner_radius, region.outer_radius});
  }
  Grid grid(grid_lines(std::move(z), axial), grid_lines(std::move(r), radial));
  Mesh mesh;
  for (int column = 0; column < grid.columns(); ++column)
    for (int row = 0; row < grid.rows(); ++row) {
      const double z0 = grid.z(column), z1 = grid.z(column + 1);
      const double r0 = grid.r(row), r1 = grid.r(row + 1);
      for (std::size_t k = 0; k < regions.size(); ++k) {
        const Region& region = regions[k];
        if (!inside(region.start, region.end, 0.5 * (z0 + z1)) ||
            !inside(region.inner_radius, region.outer_radius, 0.5 * (r0 + r1)))
          continue;
        Cell cell{region};
        cell.start = z0, cell.end = z1, cell.inner_radius = r0, cell.outer_radius = r1;
        cell.region = static_cast<int>(k), cell.column = column, cell.row = row;
        grid.set(column, row, static_cast<int>(mesh.cells.size()));
        mesh.cells.push_back(std::move(cell));
        break;
      }
    }
  add_faces(grid, mesh);
  return mesh;
}

}  // namespace raceway::spindle
