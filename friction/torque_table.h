#pragma once

#include <array>
#include <string>

#include "friction/state.h"
#include "friction/stribeck_table.h"

namespace raceway::friction {

/// Measured or precomputed friction moment of a bearing: the base law `table`.
///
///   M = scale M(n, F_a, F_r, T)
///
/// interpolated as interpolate() does, in speed, loads and the temperature of the lubricant.
/// Domain:   beyond an axis the value at its edge, so the power there is proportional to speed;
///           holds() detects such a state. An axis missing in the file accepts every value.
/// Accuracy: of the readings themselves `band`, where the file has it; between them interpolate().
struct TorqueTable {
  static constexpr std::array parameters{
      Parameter{.name = "scale", .unit = "1", .initial = 1.0, .lower = 0.01, .upper = 100.0}};

  std::string file{};    ///< as the model names it
  StribeckTable grid{};  ///< friction moment at every point
  /// Half width of the 95 % band of its error, on the same grid; empty if not known.
  StribeckTable band{};
  /// Load-dependent part of the moment, on the same grid, as in tables of `raceway table`. It
  /// shares heat between the rings. Empty if not known.
  StribeckTable load{};
  /// Axes that the file has; the others stand in the grid with one value.
  bool has_axial_load = true, has_radial_load = true, has_temperature = true;
  bool of_shaft =
      false;  ///< torque of all bearings of a shaft over the load at its nose: not a law

  [[nodiscard]] bool has_band() const { return !band.friction_moment.empty(); }
  /// Friction moment [N m]; NaN for a state without a number.
  [[nodiscard]] double moment(const BearingState<>& state) const { return value(grid, state); }
  /// Half width of the band at a state [N m]; NaN without one.
  [[nodiscard]] double half_width(const BearingState<>& state) const {
    return has_band() ? value(band, state) : unset;
  }
  /// Load-dependent part at a state [N m]; 0 if not known.
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
