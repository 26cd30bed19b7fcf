#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Common law of the forms for a rig and for a shaft: the temperature difference of the rings
/// increases the preload.
///
///   x = c P,   P = (M1 + M0) ω of the base law at the load as entered or mounted
///
/// x is the added axial load on a rig, or the radial growth in the sets of a shaft. c is a fitted
/// factor, and P the friction power. M1 is the load moment, M0 the viscous moment, and ω the speed.
/// Source:   steady heat flow: the temperature difference of the rings is proportional to the
///           friction power (Stein and Tu 1994; Bossmanns and Tu 1999 describe the loop of heat,
///           growth and preload). P is computed at the load without the effect, so that the loop
///           of heat and preload does not diverge.
/// Domain:   speed >= 0.
struct PreloadByOwnHeat {
  static constexpr std::string_view id = "thermal-preload";
  static constexpr std::string_view title =
      "preload that grows with the friction heat of the bearing";
  static constexpr std::string_view source =
      "steady heat flow, derived; feedback loop of [SteinTu1994], [BossmannsTu1999]";
  static constexpr bool follows_heat = true;
  static constexpr bool uses_power = true;
  static constexpr std::string_view not_for_rollers = "the effect depends on the contact angle";
};

/// Increase of the axial load of a bearing on a rig, caused by its friction heat [N].
///
///   F_a -> F_a + c P,   P = (M1 + M0) ω at the entered load
///
/// In a rigid set, the load is proportional to the temperature difference. With a spring preload, c
/// = 0.
struct ThermalPreload : PreloadByOwnHeat {
  static constexpr Form form = Form::rig;
  static constexpr std::string_view mechanism =
      "Friction warms the inner ring and the balls more than the outer ring. In a rigid set, inner "
      "ring and balls cannot expand freely, and the load grows with the friction power.";
  static constexpr std::string_view formula =
      "F_a + c P in place of F_a, P = (M1 + M0) w at the entered load";
  static constexpr std::array<std::string_view, 4> confused_with{
      "centrifugal-ring-growth", "spin-friction", "lubricant-drag", "windage"};
  static constexpr std::string_view settled_by =
      "the torque soon after a change of speed and again when the bearing is warm";
  static constexpr std::array parameters{Parameter{.name = "force_per_power_N_W",
                                                   .unit = "N/W",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 100.0,
                                                   .plausible_lower = 0.05,
                                                   .plausible_upper = 5.0}};
  static constexpr std::array needs{Need::speed_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.extra_axial_load += values[0] * in.power;
  }
};

/// Radial growth of the inner raceway relative to the outer one, caused by the friction heat of the
/// bearing, in the sets of a shaft [m].
///
///   g = c P,   P = (M1 + M0) ω at the bearing's share of the preload
///
/// The free expansion λ d_m/2 (λ: thermal expansion, d_m: pitch diameter) is about 0.5 um/K. With a
/// thermal resistance of 0.01 to 0.1 K/W between the rings, c is 0.005 to 0.05 um/W. If the ring
/// temperatures are measured, the equilibrium already includes the expansion of the rings, and c
/// describes only the remaining growth.
struct ShaftThermalPreload : PreloadByOwnHeat {
  static constexpr Form form = Form::shaft;
  // The temperatures of a spindle already include this growth.
  static constexpr bool for_spindle = false;
  static constexpr std::string_view mechanism =
      "Friction warms the inner rings and the balls more than the outer rings. Inner rings and "
      "balls cannot expand freely, so the preload rises with the friction power.";
  static constexpr std::string_view formula =
      "inner raceway grows by c P in radius, P = (M1 + M0) w at the preload";
  static constexpr std::array<std::string_view, 4> confused_with{
      "centrifugal-ring-growth", "thermal-ring-growth", "shaft-contraction", "mounting"};
  static constexpr std::array parameters{Parameter{.name = "growth_per_power_um_W",
                                                   .unit = "um/W",
                                                   .initial = 0.01,
                                                   .lower = 0.0,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.001,
                                                   .plausible_upper = 0.1}};
  static constexpr std::array needs{Need::speed_levels, Need::preload_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.radial_growth += values[0] * um * in.power;
  }
};

}  // namespace raceway::effects
