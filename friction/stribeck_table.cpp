#include "friction/stribeck_table.h"

// Boost 1.74's pchip.hpp calls isnan() unqualified, so the C header has to come before it.
#include <math.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <array>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <limits>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace raceway::friction {
namespace {

constexpr std::size_t piece = 256;       // points that are filled in one go
constexpr double grid_tolerance = 1e-9;  // relative distance at which a position is a grid value

/// An axis by the name and unit in which messages speak of it.
struct Axis {
  const char* name;
  const char* unit;
  double scale, offset;  // shown = (value - offset) / scale
  double lowest;         // smallest value allowed
  [[nodiscard]] double shown(double value) const { return (value - offset) / scale; }
};

constexpr Axis speed_axis{"speed", "rpm", rpm, 0.0, 0.0};
constexpr Axis axial_axis{"axial_load", "N", 1.0, 0.0, -1e9};
constexpr Axis radial_axis{"radial_load", "N", 1.0, 0.0, 0.0};
constexpr Axis temperature_axis{"temperature", "C", 1.0, celsius_zero, 0.0};

void validate_axis(const Axis& axis, const std::vector<double>& values) {
  std::ostringstream text;
  if (values.empty()) {
    text << axis.name << ": a table needs at least one value";
    throw std::invalid_argument(text.str());
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(std::isfinite(values[i]) && values[i] >= axis.lowest)) {
      text << axis.name << " = " << axis.shown(values[i]) << ' ' << axis.unit
           << ": must be finite and at least " << axis.shown(axis.lowest) << ' ' << axis.unit;
      throw std::invalid_argument(text.str());
    }
    if (i > 0 && values[i] <= values[i - 1]) {
      text << axis.name << " = " << axis.shown(values[i]) << ' ' << axis.unit
           << ": must be above the value before it, " << axis.shown(values[i - 1]) << ' '
           << axis.unit;
      throw std::invalid_argument(text.str());
    }
  }
}

/// The grid values that an interpolation at x rests on.
struct Stencil {
  std::size_t first = 0;
  std::size_t count = 1;
  double x = unset;
  bool clamped = false;
};

Stencil stencil(const Axis& axis, const std::vector<double>& grid, double x, Outside outside) {
  const auto near = [](double a, double b) {
    return std::abs(a - b) <= grid_tolerance * std::max(std::abs(a), std::abs(b));
  };
  Stencil s{.x = x};
  const bool inside = std::isfinite(x) && ((x >= grid.front() && x <= grid.back()) ||
                                           near(x, grid.front()) || near(x, grid.back()));
  if (!inside) {
    if (outside == Outside::error || !std::isfinite(x)) {
      std::ostringstream text;
      text.precision(10);
      text << axis.name << " = " << axis.shown(x) << ' ' << axis.unit << ": the table covers ";
      if (grid.size() > 1) text << "from " << axis.shown(grid.front()) << " to ";
      text << axis.shown(grid.back()) << ' ' << axis.unit;
      throw std::invalid_argument(text.str());
    }
    s.clamped = true;
  }
  s.x = std::clamp(x, grid.front(), grid.back());
  const auto above = std::upper_bound(grid.begin(), grid.end(), s.x);
  const auto upper =
      std::min<std::size_t>(static_cast<std::size_t>(above - grid.begin()), grid.size() - 1);
  const std::size_t lower = upper > 0 ? upper - 1 : 0;
  // On a grid value nothing but that value counts, not even a neighbour without balance.
  for (const std::size_t k : {lower, upper})
    if (near(s.x, grid[k])) return {.first = k, .count = 1, .x = grid[k], .clamped = s.clamped};
  if (grid.size() < 4) {
    s.first = lower;
    s.count = 2;
    return s;
  }
  // PCHIP takes its slopes from direct neighbours: four points give the same as the whole line.
  s.first = std::min(lower > 0 ? lower - 1 : 0, grid.size() - 4);
  s.count = 4;
  return s;
}

double interpolate_line(const std::vector<double>& grid, const Stencil& s, const double* y) {
  if (s.count == 1) return y[0];
  const double* const x = grid.data() + s.first;
  if (s.count == 2) return y[0] + (y[1] - y[0]) * ((s.x - x[0]) / (x[1] - x[0]));
  return boost::math::interpolators::pchip<std::vector<double>>(std::vector<double>(x, x + 4),
                                                                std::vector<double>(y, y + 4))(s.x);
}

}  // namespace

std::size_t TableAxes::size() const {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  std::size_t product = 1;
  for (const auto* axis : {&speed, &axial_load, &radial_load, &temperature}) {
    if (axis->size() > 0 && product > most / axis->size()) return most;
    product *= axis->size();
  }
  return product;
}

void validate(const TableAxes& axes) {
  validate_axis(speed_axis, axes.speed);
  validate_axis(axial_axis, axes.axial_load);
  validate_axis(radial_axis, axes.radial_load);
  validate_axis(temperature_axis, axes.temperature);
  if (axes.size() == std::numeric_limits<std::size_t>::max())
    throw std::invalid_argument(
        "the table has too many points: give fewer speeds, loads or temperatures");
}

std::size_t StribeckTable::index(std::size_t speed, std::size_t axial_load, std::size_t radial_load,
                                 std::size_t temperature) const {
  return ((temperature * axes.radial_load.size() + radial_load) * axes.axial_load.size() +
          axial_load) *
             axes.speed.size() +
         speed;
}

bearing::OperatingPoint StribeckTable::point(std::size_t index) const {
  const auto next = [&index](const std::vector<double>& axis) {
    const double value = axis[index % axis.size()];
    index /= axis.size();
    return value;
  };
  bearing::OperatingPoint p;
  p.speed = next(axes.speed);
  p.axial_load = next(axes.axial_load);
  p.radial_load = next(axes.radial_load);
  p.temperature = next(axes.temperature);
  return p;
}

std::span<const double> StribeckTable::row(std::size_t index) const {
  return std::span(values).subspan(index * columns.size(), columns.size());
}

StribeckTable build_stribeck_table(const TableAxes& axes, std::vector<std::string> columns,
                                   const TableLine& line,
                                   const std::function<void(double)>& progress,
                                   const TableSlab& slab) {
  validate(axes);
  if (slab.index >= slab.count)
    throw std::invalid_argument("slab " + std::to_string(slab.index + 1) + " of " +
                                std::to_string(slab.count) +
                                ": the slab number must be at most the number of slabs");
  StribeckTable table;
  table.axes = axes;
  table.slab = slab;
  table.columns = std::move(columns);
  const std::size_t points = table.points(), width = table.columns.size();
  table.friction_moment.assign(points, unset);
  table.status.assign(points, bearing::SolveStatus::not_run);
  table.values.assign(points * width, unset);

  const std::size_t pieces = (points + piece - 1) / piece;
  std::mutex progress_mutex;
  std::size_t done = 0;
  const auto fill = [&](std::size_t k) {
    const std::size_t first = k * piece, count = std::min(piece, points - first);
    std::array<bearing::OperatingPoint, piece> given;
    std::array<TablePoint, piece> results;
    for (std::size_t i = 0; i < count; ++i) {
      given[i] = table.point(table.first() + first + i);
      results[i].columns = std::span(table.values).subspan((first + i) * width, width);
    }
    line(std::span(given).first(count), std::span(results).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      table.status[first + i] = results[i].status;
      if (std::isfinite(results[i].friction_moment))
        table.friction_moment[first + i] = results[i].friction_moment;
    }
    if (!progress) return;
    const std::lock_guard lock(progress_mutex);
    ++done;
    progress(static_cast<double>(done) / static_cast<double>(pieces));
  };
  tbb::parallel_for(std::size_t{0}, pieces, fill, tbb::simple_partitioner());
  return table;
}

InterpolatedMoment interpolate(const StribeckTable& table, const TablePosition& position,
                               Outside outside) {
  if (table.slab.count != 1)
    throw std::invalid_argument("a slab is only a part of a table: merge all slabs first");
  const TableAxes& axes = table.axes;
  const Stencil n = stencil(speed_axis, axes.speed, position.speed, outside);
  const Stencil a = stencil(axial_axis, axes.axial_load, position.axial_load, outside);
  const Stencil r = stencil(radial_axis, axes.radial_load, position.radial_load, outside);
  const Stencil t = stencil(temperature_axis, axes.temperature, position.temperature, outside);

  std::array<double, 4> by_temperature{}, by_radial{}, by_axial{};
  for (std::size_t it = 0; it < t.count; ++it) {
    for (std::size_t ir = 0; ir < r.count; ++ir) {
      for (std::size_t ia = 0; ia < a.count; ++ia)
        by_axial[ia] = interpolate_line(
            axes.speed, n,
            &table.friction_moment[table.index(n.first, a.first + ia, r.first + ir, t.first + it)]);
      by_radial[ir] = interpolate_line(axes.axial_load, a, by_axial.data());
    }
    by_temperature[it] = interpolate_line(axes.radial_load, r, by_radial.data());
  }
  return {.friction_moment = interpolate_line(axes.temperature, t, by_temperature.data()),
          .clamped = n.clamped || a.clamped || r.clamped || t.clamped};
}

}  // namespace raceway::friction
