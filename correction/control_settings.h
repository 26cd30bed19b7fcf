#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Settings for a correction that runs on a machine control, from the table [export] of a model
/// file: see docs/control.md.
namespace raceway::correction {

/// A setting with one value for all inputs or axes, and exceptions for some columns.
template <typename T>
struct ByColumn {
  T all{};
  std::vector<std::pair<std::string, T>> columns{};

  [[nodiscard]] T of(std::string_view column) const {
    for (const auto& [name, value] : columns)
      if (name == column) return value;
    return all;
  }
  [[nodiscard]] bool names(std::string_view column) const {
    for (const auto& one : columns)
      if (one.first == column) return true;
    return false;
  }
};

struct ControlLimits {
  double low = 0.0, high = 0.0;
};

/// Settings in the units of the model file: um (urad for an angle) and s. Limits of an input have
/// the unit of its column.
struct ControlSettings {
  // Settings of axes, by the column of their displacement.
  ByColumn<double> limit_um{100.0};  ///< largest absolute value of the offset
  ByColumn<double> slew_um_s{1.0};   ///< largest rate of change of the offset
  /// offset = sign * displacement; -1 moves the axis against the displacement
  ByColumn<double> sign{-1.0};
  /// Unit of the output: "um", "mm", "counts"; for an angle "urad", "mrad", "rad", "deg", "counts".
  ByColumn<std::string> unit{"um"};
  ByColumn<double> count_um{0.1};  ///< size of one count of the output
  /// Letter of the axis. If it is empty, the column gives the letter: z for displacement_z_um.
  ByColumn<std::string> axis{};
  // Settings of inputs, by their column.
  /// Plausible range of an input. `all` applies to temperatures only. For another input that
  /// `columns` does not name, the limit is 10 times its largest absolute value in the data of the
  /// fit; coolant_on has no limit.
  ByColumn<ControlLimits> plausible{
      {-40.0, 150.0}, {}};  ///< `all`: limits of temperatures that `columns` does not name [°C]
  /// Largest allowed change of an input per second; 0: not checked. `all` applies to temperatures
  /// only. Other inputs are checked only if `columns` names them.
  ByColumn<double> fastest_per_s{1.0};
  /// Longest allowed time without a change of an input [s]; 0: not checked. `all` applies to
  /// temperatures only. Other inputs are checked only if `columns` names them.
  ByColumn<double> stuck_s{3600.0};
  /// Time constant of a filter on an input [s]; 0: no filter. Only contributions without a lag use
  /// the filtered input.
  ByColumn<double> smoothing_s{0.0};
  // Settings of all axes and inputs.
  /// Reaction to a fault that lasts longer than `hold_s`: the model uses the last good input
  /// ("hold"), or the offset moves to the last offset from good inputs ("last-safe") or to 0
  /// ("zero").
  std::string on_fault = "last-safe";
  double hold_s = 60.0, fade_s = 300.0;
  double longest_gap_s = 10.0, clock_jump_s = 1800.0;
  /// State of the lags after a time in which the control was off: simulated for this time with
  /// speeds, feeds and powers of 0 ("decay"), unchanged ("resume"), or zero ("rest").
  std::string restart = "decay";
  /// Applied offsets when a new datum is set: they become part of the datum ("keep"), or the
  /// control removes them ("clear").
  std::string touch_off = "keep";
  /// Offsets while the correction is disabled: they move to 0 ("zero") or stay constant ("freeze").
  std::string disabled = "zero";
  /// Response of lags to inputs beyond the range of the fit: linear in the input ("linear"),
  /// or as for an input at the limit of the range ("hold").
  std::string beyond_range = "linear";
};

}  // namespace raceway::correction
