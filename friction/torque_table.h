#pragma once

#include <array>
#include <string>

#include "friction/state.h"
#include "friction/stribeck_table.h"

namespace raceway::friction {

/// Measured or precomputed friction moment of a bearing: the base law `table`.
///
///   M = scale M_t(n, F_a, F_r, T)
///
/// interpolate() computes the moment M_t of the table from the speed n, the magnitudes of the axial
/// load F_a and the radial load F_r, and the temperature T of the lubricant.
/// Domain:   outside the range of an axis, the moment at the edge of the range is used, and holds()
///           returns false. Above the highest speed, the friction power is therefore proportional
///           to the speed. The moment does not depend on an input for which the file has no axis.
/// Accuracy: at the grid points, the error of the moment is at most `band` with a probability of 95
///           %, if the file gives a band. Between the grid points, interpolate() adds an
///           interpolation error.
struct TorqueTable {
  static constexpr std::array parameters{
      Parameter{.name = "scale", .unit = "1", .initial = 1.0, .lower = 0.01, .upper = 100.0}};

  std::string file{};    ///< file name as in the model file
  StribeckTable grid{};  ///< friction moment at every grid point
  /// Half width of the 95 % error band of the moment, on the same grid; empty if not known.
  StribeckTable band{};
  /// Load-dependent part of the moment, on the same grid, as in tables of `raceway table`; empty if
  /// not known. split_heat() uses this part to split the heat between the rings.
  StribeckTable load{};
  /// True if the file has a column for the axial load, the radial load or the temperature,
  /// respectively. The axis of an input without a column has one value in `grid`.
  bool has_axial_load = true, has_radial_load = true, has_temperature = true;
  /// True if the table gives the torque of a whole shaft as a function of the load at the nose.
  /// Such a table cannot be a base law.
  bool of_shaft = false;

  [[nodiscard]] bool has_band() const { return !band.friction_moment.empty(); }
  /// Friction moment of the table, without the factor `scale` [N m]; NaN if an input for which the
  /// table has an axis is not finite.
  [[nodiscard]] double moment(const BearingState<>& state) const { return value(grid, state); }
  /// Half width of the 95 % error band at a state [N m]; NaN without a band.
  [[nodiscard]] double half_width(const BearingState<>& state) const {
    return has_band() ? value(band, state) : unset;
  }
  /// Load-dependent part of the moment at a state [N m]; 0 if not known.
  [[nodiscard]] double load_moment(const BearingState<>& state) const {
    return load.friction_moment.empty() ? 0.0 : value(load, state);
  }
  /// True if the state lies within the ranges of all axes. Throws std::invalid_argument if an input
  /// for which the table has an axis is not finite.
  [[nodiscard]] bool holds(const BearingState<>& state) const;
  /// Ranges of the axes in the file: "500 to 9000 rpm, 100 to 400 N axial, 20 to 70 C".
  [[nodiscard]] std::string range() const;

 private:
  [[nodiscard]] TablePosition position(const BearingState<>& state) const;
  [[nodiscard]] double value(const StribeckTable& of, const BearingState<>& state) const;
};

}  // namespace raceway::friction
