#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Settings in the table [export] of a model file, for a correction that runs on a machine control:
/// see docs/control.md. The offset is the correction value by which the control moves an axis.
namespace raceway::correction {

/// Setting of inputs or axes. `columns` contains values for single columns; the value `all` is for
/// other columns.
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
  // Settings of axes. An entry in `columns` names the displacement column of the axis.
  ByColumn<double> limit_um{100.0};  ///< largest absolute value of the offset
  ByColumn<double> slew_um_s{1.0};   ///< largest rate of change of the offset
  /// Factor from displacement to offset; with -1, the offset moves the axis against the
  /// displacement.
  ByColumn<double> sign{-1.0};
  /// Unit of the offset that the program outputs: "um", "mm", "counts"; for an angle "urad",
  /// "mrad", "rad", "deg", "counts".
  ByColumn<std::string> unit{"um"};
  ByColumn<double> count_um{0.1};  ///< size of one count if the offset is output in counts
  /// Letter of the axis. If the text is empty, the letter is taken from the column name: z for
  /// displacement_z_um.
  ByColumn<std::string> axis{};
  // Settings of inputs. An entry in `columns` names the column of the input.
  /// Plausible range of an input. The value `all` is for temperatures. For any other input without
  /// an entry in `columns`, the limit is 10 times the largest absolute value of this input in the
  /// data of the fit. The input coolant_on has no limit. Limits of temperatures are in °C.
  ByColumn<ControlLimits> plausible{{-40.0, 150.0}, {}};
  /// Largest allowed change of an input per second; 0: not checked. The value `all` is for
  /// temperatures. Other inputs are checked if they have an entry in `columns`.
  ByColumn<double> fastest_per_s{1.0};
  /// Longest allowed time without a change of an input [s]; 0: not checked. The value `all` is for
  /// temperatures. Other inputs are checked if they have an entry in `columns`.
  ByColumn<double> stuck_s{3600.0};
  /// Time constant of a filter on an input [s]; 0: no filter. The filtered input is used for
  /// contributions without a lag. Contributions with a lag use the unfiltered input.
  ByColumn<double> smoothing_s{0.0};
  // Settings of all axes and inputs.
  /// Reaction to a fault of an input that lasts longer than `hold_s` [s]. "hold": the model uses
  /// the last good input. "last-safe": the offset moves to the last offset from good inputs.
  /// "zero": the offset moves to 0.
  std::string on_fault = "last-safe";
  double hold_s = 60.0, fade_s = 300.0;
  double longest_gap_s = 10.0, clock_jump_s = 1800.0;
  /// State of the lags after the control was off. "decay": the program simulates the off time with
  /// speeds, feeds and powers of 0. "resume": the state is unchanged. "rest": the state is zero.
  std::string restart = "decay";
  /// Treatment of the applied offsets when a new datum (touch-off) is set. "keep": the offsets
  /// become part of the datum. "clear": the control removes the offsets.
  std::string touch_off = "keep";
  /// Offsets while the correction is disabled. "zero": the offsets move to 0. "freeze": the offsets
  /// stay constant.
  std::string disabled = "zero";
  /// Response of lags to an input beyond the range of the fit. "linear": the response is linear in
  /// the input. "hold": the input is limited to the range.
  std::string beyond_range = "linear";
};

}  // namespace raceway::correction
