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

/// Grid of a Stribeck table. Each axis has at least one value. The values of an axis increase
/// strictly.
struct TableAxes {
  std::vector<double> speed;        ///< [rad/s], >= 0
  std::vector<double> axial_load;   ///< [N]
  std::vector<double> radial_load;  ///< radial load along +y [N], >= 0
  std::vector<double> temperature;  ///< temperatures of the lubricant [K], > 0

  /// Number of grid points; the largest std::size_t if this number overflows.
  [[nodiscard]] std::size_t size() const;
};

/// Throws std::invalid_argument if an axis is empty, not increasing or out of range, or if the
/// number of points overflows. For a wrong axis, the message names the axis.
void validate(const TableAxes& axes);

/// Results at one point of a table.
struct TablePoint {
  /// Status of the equilibrium solver. For a converged equilibrium, the status is `not_finite` if a
  /// moment, the power loss or the shaft position is not finite, otherwise `converged`. The
  /// friction moment can be valid even if the equilibrium did not converge, because some friction
  /// laws do not use the equilibrium.
  bearing::SolveStatus status = bearing::SolveStatus::not_run;
  double friction_moment = unset;  ///< [N m]
  std::span<double> columns;       ///< additional values, in the order of StribeckTable::columns
};

/// Part of a table that is computed in several parts: one of `count` blocks of consecutive points.
/// By default, the slab is the whole table.
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
  /// Returns size * n / count, rounded down, without overflow of size * n.
  [[nodiscard]] std::size_t part(std::size_t size, std::size_t n) const {
    return size / count * n + size % count * n / count;
  }
};

/// Friction moment of a bearing over speed, loads and temperature, with further columns (parts of
/// the moment, contact angles, ...) by name. In the order of the points, speed varies fastest, then
/// axial load, radial load and temperature.
struct StribeckTable {
  TableAxes axes;
  TableSlab slab;                    ///< part of the grid for which the members below have values
  std::vector<std::string> columns;  ///< names with the units in files, such as "power_loss_W"
  std::vector<double> friction_moment;       ///< moments [N m]; NaN if a point has no value
  std::vector<bearing::SolveStatus> status;  ///< TablePoint::status of each point
  std::vector<double> values;  ///< values of all `columns` in SI units, point by point

  /// Index of a grid point in the whole table. The arguments are its indices on the four axes.
  [[nodiscard]] std::size_t index(std::size_t speed, std::size_t axial_load,
                                  std::size_t radial_load, std::size_t temperature) const;
  /// Number of points in this slab.
  [[nodiscard]] std::size_t points() const { return slab.points(axes.size()); }
  /// Index of the first point of this slab in the whole table.
  [[nodiscard]] std::size_t first() const { return slab.first(axes.size()); }
  /// Operating point of the grid point with this index in the whole table.
  [[nodiscard]] bearing::OperatingPoint point(std::size_t index) const;
  /// Additional values of a point, in the order of `columns`. `index` counts the points of the slab
  /// from 0.
  [[nodiscard]] std::span<const double> row(std::size_t index) const;
};

/// Function that computes the results (TablePoint) at several operating points of a table. Several
/// threads call the function in parallel.
using TableLine =
    std::function<void(std::span<const bearing::OperatingPoint>, std::span<TablePoint>)>;

/// Fills a table, or one slab of it, on all cores.
///
/// The table is divided into pieces of at most 256 points, independent of the number of threads.
/// `line` gets one piece in each call. The table does not depend on the number of threads if `line`
/// calculates its results only from the points of the piece. The joined slabs of a table equal the
/// whole table if `line` calculates the result of a point only from the operating point of this
/// point. `progress` receives the finished fraction, from 0 to 1. Calls of `progress` do not
/// overlap. An exception from `line` or `progress` ends the build and reaches the caller. Throws
/// std::invalid_argument like validate(axes), and if slab.index >= slab.count. The function needs
/// memory for the result and for one piece per thread.
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
  double friction_moment = unset;  ///< moment [N m]; NaN if a required grid point has no value
  bool clamped = false;            ///< true: the position was outside the table
  [[nodiscard]] bool has_value() const { return !std::isnan(friction_moment); }
};

/// Friction moment between the points of a table [N m].
///
/// The function interpolates over one axis after the other, speed first and temperature last: by
/// monotone cubic Hermite splines (PCHIP) on an axis of four or more points, linearly on an axis of
/// two or three points. If an axis has one point, a query with another value on this axis is
/// outside the table. The moment is NaN if the interpolation needs a grid point without a value.
///
/// Source:   Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984), as in Boost.Math.
/// Domain:   the closed range of each axis, with a relative margin of 1e-9 for rounding in unit
///           conversions. The function throws std::invalid_argument if `table` is a slab and not a
///           whole table. With either value of `outside`, the function also throws if a member of
///           `position` is not finite.
/// Accuracy: the moment is exact at grid points. For equal spacing h of the grid points, the error
///           is of order h³, and of order h² near the ends of an axis and near an extremum. Along a
///           grid line, the moment is monotone where the values of the grid points are monotone.
///           Between grid lines, the moment is not always monotone.
[[nodiscard]] InterpolatedMoment interpolate(const StribeckTable& table,
                                             const TablePosition& position, Outside outside);

}  // namespace raceway::friction
