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
/// c is the relative change of the true load per kelvin, at the same recorded load F_a.
/// Source:   definition. Compensated cells drift by 0.002 to 0.05 % per kelvin. Heating from one
///           side, or the expansion of the housing against the loading device, causes ten times
///           this drift.
/// Domain:   loads not below zero. T is the temperature of the row (temperature_C); the temperature
///           of the cell may differ. Under pure axial load, another reference temperature than
///           20 °C would change the fitted c and the fitted factor z of Palmgren's load moment, but
///           not the predicted torque.
struct LoadCellDrift {
  static constexpr std::string_view id = "load-cell-drift";
  static constexpr Form form = Form::rig;
  static constexpr std::string_view title = "the load cell drifts with its temperature";
  static constexpr std::string_view datum = "the load cell at the temperature of the rig";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the gain of the load cell changes with the temperature of "
      "the rig.";
  static constexpr std::string_view formula = "F_a (1 + c (T - 20 C)) in place of F_a";
  static constexpr std::string_view source = "definition; range assumed";
  static constexpr std::array<std::string_view, 4> confused_with{
      "spin-friction", "gyroscopic-slip", "thermal-preload", "load-calibration"};
  static constexpr std::string_view settled_by =
      "the load cell under a known weight, cold and warm";
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
