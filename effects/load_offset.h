#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Axial load in addition to the entered axial load [N].
///
///   F_a -> F_a + c
///
/// F_a is the entered axial load, and c the fitted additional load.
/// Source:   definition. Possible causes are a preload spring, a zero error of the load cell, and
///           the pull of a belt.
/// Domain:   F_a + c must not be negative.
struct LoadOffset {
  static constexpr std::string_view id = "load-offset";
  static constexpr Form form = Form::rig;
  static constexpr std::string_view title = "additional load that was not entered";
  static constexpr std::string_view mechanism =
      "Springs, a belt or a zero error of the load cell add a constant force to the entered "
      "load. The effect is largest at small entered loads.";
  static constexpr std::string_view formula =
      "F_a + c in place of the axial load F_a (c: additional force)";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 4> confused_with{"seal-friction", "torque-offset",
                                                                 "load-exponent", "z"};
  static constexpr std::string_view settled_by =
      "the zero of the load cell on the unloaded rig, before and after the test";
  static constexpr std::array parameters{Parameter{.name = "force_N",
                                                   .unit = "N",
                                                   .initial = 50.0,
                                                   .lower = -5000.0,
                                                   .upper = 5000.0,
                                                   .plausible_lower = -300.0,
                                                   .plausible_upper = 300.0}};
  static constexpr double size_power = 2.0;
  static constexpr std::array needs{Need::load_levels};
  static constexpr std::string_view not_for_rollers =
      "the effect is an axial force, which cylindrical rollers do not carry";

  static void condition(const ConditionInputs&, std::span<const double> values, Condition& c) {
    c.extra_axial_load += values[0];
  }
};

}  // namespace raceway::effects
