#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Settings of a correction on a control, [export] of a model file: docs/control.md.
namespace raceway::correction {

/// A value for all inputs or axes, and others for some of them.
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

/// Units are the units of the files: um, for an angle urad, s, C, and for an input the unit of its
/// column.
struct ControlSettings {
  // Axes, by the column of their displacement.
  ByColumn<double> limit_um{100.0};  ///< an offset is at most this, either way
  ByColumn<double> slew_um_s{1.0};   ///< and goes no faster
  ByColumn<double> sign{-1.0};       ///< offset = sign * displacement: an axis moves against it
  ByColumn<std::string> unit{"um"};  ///< of what is handed out: "um", "mm", "counts";
                                     ///< of an angle "urad", "mrad", "rad", "deg", "counts"
  ByColumn<double> count_um{0.1};    ///< of one count
  ByColumn<std::string> axis{};  ///< letter of the axis; empty: LETTER of displacement_LETTER_um
  // Inputs, by their column.
  ByColumn<ControlLimits> plausible{
      {-40.0, 150.0}, {}};  ///< `all`: of temperatures alone; others ten times their range
  ByColumn<double> fastest_per_s{1.0};  ///< `all`: of temperatures alone; 0: not asked
  ByColumn<double> stuck_s{3600.0};     ///< `all`: of temperatures alone; 0: not asked
  ByColumn<double> smoothing_s{0.0};    ///< that instant parts feel them with
  // All axes and inputs.
  std::string on_fault = "last-safe";  ///< after the hold: "hold", "last-safe", "zero"
  double hold_s = 60.0, fade_s = 300.0;
  double longest_gap_s = 10.0, clock_jump_s = 1800.0;
  std::string restart = "decay";        ///< after a longer gap: "decay", "resume", "rest"
  std::string touch_off = "keep";       ///< what is applied then: "keep", "clear"
  std::string disabled = "zero";        ///< where offsets go then: "zero", "freeze"
  std::string beyond_range = "linear";  ///< sections there: "linear", "hold"
};

}  // namespace raceway::correction
