#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bearing/operating_point.h"
#include "bearing/solve.h"
#include "record/units.h"

namespace raceway::friction {

/// Grid of a Stribeck table. Each axis has at least one value, and its values increase strictly.
struct TableAxes {
  std::vector<double> speed;        ///< [rad/s], >= 0
  std::vector<double> axial_load;   ///< [N]
  std::vector<double> radial_load;  ///< radial load along +y [N], >= 0
  std::vector<double> temperature;  ///< temperatures of the lubricant [K], > 0

  /// Number of grid points; the largest std::size_t if this number overflows.
  [[nodiscard]] std::size_t size() const;
};

/// Throws std::invalid_argument if an axis is empty, not increasing or out of range (the message
/// names the axis), and if the number of points overflows.
void validate(const TableAxes& axes);

/// Values at one point of a table.
struct TablePoint {
  /// Status of the point: the status of an equilibrium that did not converge; otherwise
  /// `converged`, or `not_finite` if a moment, power loss or shaft position is not finite. A
  /// friction law that does not use the equilibrium gives a moment even if the balls have no
  /// equilibrium.
  bearing::SolveStatus status = bearing::SolveStatus::not_run;
  double friction_moment = unset;  ///< [N m]
  std::span<double> columns;       ///< additional values, in the order of StribeckTable::columns
};

/// One of `count` blocks of consecutive points into which a table is divided. The default is the
/// whole table.
struct TableSlab {
  std::size_t index = 0;  ///< index of the block, from 0
  std::size_t count = 1;
  /// Number of points before this slab in a table of `size` points.
  [[nodiscard]] std::size_t first(std::size_t size) const { return part(size, index); }
  /// Number of points in this slab of a table of `size` points.
  [[nodiscard]] std::size_t points(std::size_t size) const {
    return part(size, index + 1) - first(size);
  }

 private:
  /// size * n / count without overflow.
  [[nodiscard]] std::size_t part(std::size_t size, std::size_t n) const {
    return size / count * n + size % count * n / count;
  }
};

/// Friction moment of a bearing over speed, loads and temperature, with further columns (parts of
/// the moment, contact angles, ...) by name. Speed varies fastest, then axial load, radial load,
/// temperature.
struct StribeckTable {
  TableAxes axes;
  TableSlab slab;                       ///< the members below contain the values of this slab
  std::vector<std::string> columns;     ///< names, which contain the units of files: "power_loss_W"
  std::vector<double> friction_moment;  ///< [N m]; NaN if a point has no value
  std::vector<bearing::SolveStatus> status;  ///< TablePoint::status of each point
  std::vector<double> values;  ///< values of all `columns` in SI units, point by point

  /// Index of a point in the whole table, from its index on each axis.
  [[nodiscard]] std::size_t index(std::size_t speed, std::size_t axial_load,
                                  std::size_t radial_load, std::size_t temperature) const;
  /// Number of points in this slab.
  [[nodiscard]] std::size_t points() const { return slab.points(axes.size()); }
  /// Index of the first point of this slab in the whole table.
  [[nodiscard]] std::size_t first() const { return slab.first(axes.size()); }
  /// Operating point of a table point, from the index of this point in the whole table.
  [[nodiscard]] bearing::OperatingPoint point(std::size_t index) const;
  /// Additional values of a point, in the order of `columns`. `index` counts the points of the slab
  /// from 0.
  [[nodiscard]] std::span<const double> row(std::size_t index) const;
};

/// Function that computes the TablePoint for each operating point of a piece of the table. Several
/// threads call the function in parallel.
using TableLine =
    std::function<void(std::span<const bearing::OperatingPoint>, std::span<TablePoint>)>;

/// Fills a table, or one slab of it, on all cores.
///
/// The table is divided into pieces of at most 256 points, independent of the number of threads. If
/// the results of `line` depend only on the points that it gets, the number of threads changes no
/// digit. If each result depends only on its own point, joined slabs equal the whole table.
/// `progress` is called with the finished fraction, up to 1, by one thread at a time. An exception
/// from `line` or `progress` ends the build and reaches the caller. Throws std::invalid_argument
/// like validate(axes), and if slab.index >= slab.count. Memory: the result, and one piece for each
/// thread.
[[nodiscard]] StribeckTable build_stribeck_table(const TableAxes& axes,
                                                 std::vector<std::string> columns,
                                                 const TableLine& line,
                                                 const std::function<void(double)>& progress = {},
                                                 const TableSlab& slab = {});

/// Treatment of a query outside the table.
enum class Outside {
  error,  ///< throws std::invalid_argument; the message names axis, value and range
  clamp,  ///< uses the nearest edge of the table, and sets InterpolatedMoment::clamped
};

/// Query point of a table.
struct TablePosition {
  double speed = unset;             ///< [rad/s]
  double axial_load = unset;        ///< [N]
  double radial_load = 0.0;         ///< [N]
  double temperature = kelvin(40);  ///< [K]
};

struct InterpolatedMoment {
  double friction_moment = unset;  ///< [N m]; NaN if a required grid point has no value
  bool clamped = false;            ///< true if the position was outside and moved to the edge
  [[nodiscard]] bool has_value() const { return !std::isnan(friction_moment); }
};

/// Friction moment between the points of a table [N m].
///
/// The function interpolates over one axis after the other, speed first and temperature last:
/// monotone cubic Hermite (PCHIP) on an axis of four points or more, linear on two or three points.
/// The range of an axis with one point is this point. The moment is NaN if it depends on a grid
/// point without a value.
///
/// Source:   Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984), as in Boost.Math.
/// Domain:   the closed range of each axis, with a relative margin of 1e-9 for rounding in unit
///           conversions. The function throws std::invalid_argument if `table` is a slab and not a
///           whole table. With either value of `outside`, the function also throws if a member of
///           `position` is not finite.
/// Accuracy: the moment is exact at grid points. For equal spacing h of the grid points, the error
///           is of order h³, and of order h² near the ends of an axis and near an extremum. Along a
///           grid line, the moment is monotone where the values of the grid points are monotone.
///           Between grid lines, the moment is usually monotone, but not always.
[[nodiscard]] InterpolatedMoment interpolate(const StribeckTable& table,
                                             const TablePosition& position, Outside outside);

}  // namespace raceway::friction
