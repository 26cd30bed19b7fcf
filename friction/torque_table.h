#pragma once

#include <array>
#include <string>

#include "friction/state.h"
#include "friction/stribeck_table.h"

namespace raceway::friction {

/// Friction moment of a bearing as it was measured, or computed before: the base law `table`.
///
///   M = scale M(n, F_a, F_r, T)
///
/// interpolated as interpolate() does, in speed, loads and the temperature of the lubricant.
/// Domain:   beyond an axis the value at its edge, so that the power there is in proportion to the
///           speed; holds() tells such a state. An axis that the file lacks takes every value.
/// Accuracy: of the readings themselves `band`, where the file has it; between them interpolate().
struct TorqueTable {
  static constexpr std::array parameters{
      Parameter{.name = "scale", .unit = "1", .initial = 1.0, .lower = 0.01, .upper = 100.0}};

  std::string file{};    ///< as the model names it
  StribeckTable grid{};  ///< friction moment at every point
  /// Half width of the 95 % band of its error, on the same grid; no points where it is not known.
  StribeckTable band{};
  /// Part of the moment that goes by the loads of the contacts, on the same grid, as tables of
  /// `raceway table` have it: it shares heat between the rings. No points where it is not known.
  StribeckTable load{};
  /// Axes that the file has; the others stand in the grid with one value.
  bool has_axial_load = true, has_radial_load = true, has_temperature = true;
  bool of_shaft = false;  ///< torque of all bearings of a shaft over the load at its nose: no law

  [[nodiscard]] bool has_band() const { return !band.friction_moment.empty(); }
  /// [N m]; NaN for a state that has no number.
  [[nodiscard]] double moment(const BearingState<>& state) const { return value(grid, state); }
  /// Half width of the band there [N m]; NaN without one.
  [[nodiscard]] double half_width(const BearingState<>& state) const {
    return has_band() ? value(band, state) : unset;
  }
  /// That part there [N m]; 0 where it is not known.
  [[nodiscard]] double load_moment(const BearingState<>& state) const {
    return load.friction_moment.empty() ? 0.0 : value(load, state);
  }
  /// True for a state within the axes.
  [[nodiscard]] bool holds(const BearingState<>& state) const;
  /// "500 to 9000 rpm, 100 to 400 N axial, 20 to 70 C": axes that the file has.
  [[nodiscard]] std::string range() const;

 private:
  [[nodiscard]] TablePosition position(const BearingState<>& state) const;
  [[nodiscard]] double value(const StribeckTable& of, const BearingState<>& state) const;
};

}  // namespace raceway::friction
