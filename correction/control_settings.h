#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Contains the settings of a correction on a control, from the table [export] of a model file: see
/// docs/control.md.
namespace raceway::correction {

/// A value for all inputs or axes, and exceptions for some of them.
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

/// Units are the units of the files: um (urad for an angle), s, C, and for an input the unit of its
/// column.
struct ControlSettings {
  // Settings of axes, by the column of their displacement.
  ByColumn<double> limit_um{100.0};  ///< largest offset in either direction
  ByColumn<double> slew_um_s{1.0};   ///< largest rate of the offset
  /// offset = sign * displacement: -1 moves the axis against the displacement
  ByColumn<double> sign{-1.0};
  /// Unit of the output: "um", "mm", "counts"; for an angle "urad", "mrad", "rad", "deg", "counts".
  ByColumn<std::string> unit{"um"};
  ByColumn<double> count_um{0.1};  ///< size of one count
  ByColumn<std::string> axis{};    ///< letter of the axis; empty: LETTER of displacement_LETTER_um
  // Settings of inputs, by their column.
  ByColumn<ControlLimits> plausible{
      {-40.0, 150.0}, {}};  ///< `all` is for temperatures; other inputs: 10 times the largest value
  /// Largest allowed change per second; 0: not checked. `all` applies to temperatures only.
  ByColumn<double> fastest_per_s{1.0};
  /// Longest allowed time without a change; 0: not checked. `all` applies to temperatures only.
  ByColumn<double> stuck_s{3600.0};
  /// Time constant of a filter on an input, for the parts of the correction that follow this input
  /// without lag [s]; 0: no filter.
  ByColumn<double> smoothing_s{0.0};
  // Settings of all axes and inputs.
  std::string on_fault = "last-safe";  ///< action after the hold: "hold", "last-safe", "zero"
  double hold_s = 60.0, fade_s = 300.0;
  double longest_gap_s = 10.0, clock_jump_s = 1800.0;
  std::string restart = "decay";   ///< action after a longer gap: "decay", "resume", "rest"
  std::string touch_off = "keep";  ///< offsets at touch-off: "keep", "clear"
  std::string disabled = "zero";   ///< offsets while disabled: "zero", "freeze"
  /// Response of sections beyond the range of the fit: "linear", "hold".
  std::string beyond_range = "linear";
};

}  // namespace raceway::correction
