#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Difference between the true and the entered or recorded temperature of the machine at the flange
/// [K].
///
///   T_machine -> T_machine + R (1 - exp(-t/τ))
///
/// T_machine is the entered or recorded temperature, R the final difference, t the time, and τ the
/// time constant.
/// Source:   definition. The temperature of a large body approaches its new value with one time
///           constant.
/// Domain:   t is the time from the start of the record; R may have either sign.
struct StructureTemperature {
  static constexpr Form form = Form::spindle;
  static constexpr std::string_view id = "structure-temperature";
  static constexpr std::string_view title = "the machine at the flange becomes warmer or colder";
  static constexpr std::string_view mechanism =
      "Drives, coolant or the sun change the temperature of the machine over hours. In the "
      "spindle, the temperature of the flange changes first, even at standstill.";
  static constexpr std::string_view formula =
      "T_machine + R (1 - exp(-t/tau)) in place of T_machine (R: final temperature rise, t: "
      "time, tau: time constant)";
  static constexpr std::string_view source =
      "definition; the machine is a body with one time constant";
  static constexpr std::array<std::string_view, 4> confused_with{
      "flange-conductance", "convection-factor", "displacement-offset", "coolant"};
  static constexpr std::array parameters{Parameter{.name = "rise_K",
                                                   .unit = "K",
                                                   .initial = 2.0,
                                                   .lower = -60.0,
                                                   .upper = 60.0,
                                                   .plausible_lower = -15.0,
                                                   .plausible_upper = 15.0},
                                         Parameter{.name = "time_constant_h",
                                                   .unit = "h",
                                                   .initial = 2.0,
                                                   .lower = 0.02,
                                                   .upper = 100.0,
                                                   .plausible_lower = 0.2,
                                                   .plausible_upper = 12.0,
                                                   .neutral = unset}};
  static constexpr std::array needs{Need::time};
  static constexpr bool follows_heat = true;

  static void spindle(std::span<const double> values, SpindleCondition& c) {
    constexpr double hour = 3600.0;
    c.structure_rise += values[0];
    c.structure_time = values[1] * hour;
  }
};

}  // namespace raceway::effects
