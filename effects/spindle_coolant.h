#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Conductance of a cooled sleeve around the spindle, if the model has no such sleeve [W/K].
///
///   q = G (T_housing - T_in)
///
/// q is the heat flow from the housing to the coolant, and G the conductance. T_in is the inlet
/// temperature, or the ambient temperature if the model has no coolant. The heat flow is
/// distributed over the length of the sleeve. The sleeve covers the space between the bearing sets,
/// and the fraction `reach` of the length of each set.
///
/// Source:   definition, convection to a fluid of uniform temperature. For comparison: 2 l/min of
///           water absorb 140 W if the water becomes 1 K warmer.
/// Domain:   G >= 0. The formula does not contain the state of the pump, so the sleeve cools even
///           when the pump is off. To distinguish a sleeve from other effects, compare readings
///           with the pump on and off.
struct SleeveCoolant {
  static constexpr Form form = Form::spindle;
  static constexpr std::string_view id = "coolant";
  static constexpr std::string_view title = "a cooled sleeve that the model lacks";
  static constexpr std::string_view mechanism =
      "A fluid around the housing between the sets removes the heat quickly: the time constant is "
      "short, the housing is cold, and the preload rises because the shaft stays warm.";
  static constexpr std::string_view formula =
      "q = G (T_housing - T_in) (q: heat flow from the housing to the coolant, G: "
      "conductance, T_in: inlet temperature of the coolant, or ambient temperature if the "
      "model has no coolant)";
  static constexpr std::string_view source =
      "definition; heat transfer to a fluid of uniform temperature";
  static constexpr std::array<std::string_view, 4> confused_with{
      "convection-factor", "flange-conductance", "structure-temperature", "f0"};
  static constexpr std::array parameters{Parameter{.name = "conductance_W_K",
                                                   .unit = "W/K",
                                                   .initial = 10.0,
                                                   .lower = 0.0,
                                                   .upper = 5000.0,
                                                   .plausible_lower = 2.0,
                                                   .plausible_upper = 500.0},
                                         Parameter{.name = "reach",
                                                   .unit = "1",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.0,
                                                   .plausible_upper = 1.0}};
  static constexpr std::array needs{Need::time};
  static constexpr bool follows_heat = true;

  static void spindle(std::span<const double> values, SpindleCondition& c) {
    c.sleeve_conductance += values[0];
    if (values[0] > 0.0) c.sleeve_reach = values[1];  // `reach` has no meaning without a sleeve
  }
};

}  // namespace raceway::effects
