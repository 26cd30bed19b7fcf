#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Common part of the two forms of the effect thermal-preload: for a bearing on a rig, and for a
/// shaft. The temperature difference between the rings increases the preload.
///
///   x = c P,   P = (M1 + M0) ω
///
/// x is the added axial load on a rig, or the radial growth of the inner raceway in the bearing
/// sets of a shaft. c is a fitted factor, P the friction power, and ω the speed. M1 and M0 are the
/// load moment and the viscous moment of the friction law, both at the load without this effect.
/// Source:   steady heat flow: the temperature difference of the rings is proportional to the
///           friction power (Stein and Tu 1994). Bossmanns and Tu (1999) describe the feedback of
///           heat, growth and preload. In this effect, P does not depend on the added load, so the
///           feedback cannot diverge.
/// Domain:   speed >= 0.
struct PreloadByOwnHeat {
  static constexpr std::string_view id = "thermal-preload";
  static constexpr std::string_view title =
      "preload that grows with the friction heat of the bearing";
  static constexpr std::string_view source =
      "derived from steady heat flow; feedback of heat and preload: [SteinTu1994], "
      "[BossmannsTu1999]";
  static constexpr bool follows_heat = true;
  static constexpr bool uses_power = true;
  static constexpr std::string_view not_for_rollers = "the effect depends on the contact angle";
};

/// Increase of the axial load of a bearing on a rig, caused by its friction heat [N].
///
///   F_a -> F_a + c P,   P = (M1 + M0) ω at the entered load F_a
///
/// With a rigid preload, the added load is proportional to the temperature difference of the rings.
/// With a spring preload, friction heat does not change the load, so c is 0.
struct ThermalPreload : PreloadByOwnHeat {
  static constexpr Form form = Form::rig;
  static constexpr std::string_view mechanism =
      "Friction warms the inner ring and the balls more than the outer ring. In a rigid set, inner "
      "ring and balls cannot expand freely, and the load grows with the friction power.";
  static constexpr std::string_view formula =
      "F_a + c P in place of the axial load F_a, with the friction power P = (M1 + M0) w at "
      "the entered load (c: load per power, M1: load moment, M0: viscous moment, w: shaft "
      "speed)";
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

/// Radial growth g of the inner raceway relative to the outer raceway, caused by the friction heat
/// of the bearing, in the bearing sets of a shaft [m].
///
///   g = c P,   P = (M1 + M0) ω at the preload of the bearing
///
/// If the inner ring expands freely and is 1 K warmer than the outer ring, g is λ d_m/2, about 0.5
/// um (λ: coefficient of thermal expansion, d_m: pitch diameter). With a thermal resistance of 0.01
/// to 0.1 K/W between the rings, c is 0.005 to 0.05 um/W. If the ring temperatures are measured,
/// the equilibrium already includes the expansion of the rings, and c describes only the remaining
/// growth.
struct ShaftThermalPreload : PreloadByOwnHeat {
  static constexpr Form form = Form::shaft;
  // In a spindle, the computed temperatures already cause this growth.
  static constexpr bool for_spindle = false;
  static constexpr std::string_view mechanism =
      "Friction warms the inner rings and the balls more than the outer rings. Inner rings and "
      "balls cannot expand freely, so the preload rises with the friction power.";
  static constexpr std::string_view formula =
      "the radius of the inner raceway grows by c P, with the friction power P = (M1 + M0) "
      "w at the preload (c: growth per power, M1: load moment, M0: viscous moment, w: shaft "
      "speed)";
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
