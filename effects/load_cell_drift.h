#pragma once

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Temperature drift of a load cell's sensitivity.
///
///   F_a -> F_a (1 + c (T - 20 °C))
///
/// F_a is the recorded axial load, and the expression on the right is the true load. c is the
/// change per kelvin [1/K].
/// Source:   definition. Temperature-compensated load cells drift by 0.002 to 0.05 % per kelvin. If
///           the cell is heated from one side, or if the housing expands against the loading
///           device, the drift is about ten times larger.
/// Domain:   loads not below zero. T is the temperature in the column temperature_C; the
///           temperature of the load cell may differ. The reference temperature of 20 °C is
///           arbitrary. Under pure axial load, another reference temperature would change the
///           fitted c and the fitted factor z of Palmgren's load moment, but not the predicted
///           torque.
struct LoadCellDrift {
  static constexpr std::string_view id = "load-cell-drift";
  static constexpr Form form = Form::rig;
  static constexpr std::string_view title = "the load cell drifts with its temperature";
  static constexpr std::string_view datum = "the load cell at the temperature of the rig";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the gain of the load cell changes with the temperature of "
      "the rig.";
  static constexpr std::string_view formula =
      "F_a (1 + c (T - 20 C)) in place of the axial load F_a (T: recorded temperature, c: "
      "drift per kelvin)";
  static constexpr std::string_view source = "definition; the usual range is assumed";
  static constexpr std::array<std::string_view, 4> confused_with{
      "spin-friction", "gyroscopic-slip", "thermal-preload", "load-calibration"};
  static constexpr std::string_view settled_by =
      "the reading of the load cell under a known weight, cold and warm";
  static constexpr std::array parameters{Parameter{.name = "percent_per_K",
                                                   .unit = "%/K",
                                                   .initial = 0.0,
                                                   .lower = -0.9,
                                                   .upper = 5.0,
                                                   .plausible_lower = -0.7,
                                                   .plausible_upper = 0.7}};
  static constexpr std::array needs{Need::load_levels, Need::viscosity_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.extra_axial_load +=
        in.point.axial_load * 0.01 * values[0] * (in.point.temperature - kelvin(20.0));
  }

  static std::string correction(std::span<const double> values) {
    return fmt::format(
        "the real load changes by {:+.2g} % per kelvin relative to the recorded load", values[0]);
  }
};

}  // namespace raceway::effects
