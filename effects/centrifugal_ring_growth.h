#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Common part of CentrifugalRingGrowth (a bearing on a rig) and ShaftCentrifugalRingGrowth
/// (bearing sets of a shaft). The inner ring grows with the square of speed. Unlike the effect
/// thermal-preload, this growth follows the speed without lag.
///
///   x = c (n/10 000 rpm)²
///
/// x is the added axial load on a rig, or the radial growth in the bearing sets of a shaft. c is
/// the value of x at 10 000 rpm, and n the speed.
/// Source:   derived. The radius r of a thin free ring grows by ρ ω² r³/E, with density ρ and
///           elastic modulus E (steel, r = 45 mm, 10 000 rpm: 3.7 um). The radius of a solid disc
///           grows only by (1 - ν)/4 of the growth of the ring (ν: Poisson's ratio).
/// Domain:   every speed.
struct RingGrowthAtSpeed {
  static constexpr std::string_view id = "centrifugal-ring-growth";
  static constexpr std::string_view title = "expansion of the inner ring with speed";

  /// Returns the growth at `speed` in the unit of `size`. `size` is the growth at 10 000 rpm.
  static double at_speed(double size, double speed) {
    const double ratio = speed / (10000.0 * rpm);
    return size * ratio * ratio;
  }
};

/// Increase of the axial load of a bearing on a rig, caused by the growth of the inner ring [N].
///
///   F_a -> F_a + c (n/10 000 rpm)²
///
/// F_a is the axial load, n the speed, and c the added load at 10 000 rpm. With a rigid preload,
/// the added load is proportional to the growth of the ring. c includes the stiffness of the
/// bearing set.
struct CentrifugalRingGrowth : RingGrowthAtSpeed {
  static constexpr Form form = Form::rig;
  static constexpr std::string_view mechanism =
      "Centrifugal force expands the inner ring. In a rigid set, the ball loads then rise "
      "with the square of speed, without delay.";
  static constexpr std::string_view formula =
      "F_a + c (n/10000 rpm)^2 in place of the axial load F_a (n: speed, c: added load at "
      "10000 rpm)";
  static constexpr std::string_view source =
      "derived from the growth of a thin rotating ring, rho w^2 r^3/E (rho: density, w: "
      "angular speed, r: radius, E: elastic modulus)";
  static constexpr std::array<std::string_view, 4> confused_with{
      "thermal-preload", "lubricant-drag", "windage", "spin-friction"};
  static constexpr std::string_view settled_by =
      "the torque soon after a change of speed and again when the bearing is warm";
  static constexpr std::array parameters{Parameter{.name = "force_at_10000_rpm_N",
                                                   .unit = "N",
                                                   .initial = 50.0,
                                                   .lower = 0.0,
                                                   .upper = 20000.0,
                                                   .plausible_lower = 5.0,
                                                   .plausible_upper = 1000.0}};
  static constexpr std::array needs{Need::speed_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.extra_axial_load += at_speed(values[0], in.point.speed);
  }
};

/// Radial growth of the inner raceway relative to the outer raceway, in the bearing sets of a shaft
/// [m].
///
///   g = c (n/10 000 rpm)²
///
/// g is the growth at the speed n, and c the growth at 10 000 rpm. The inner groove moves outwards
/// by g. The contact angles then decrease, and the preload rises. The shaft moves axially, unless
/// the bearing sets at both ends have equal stiffness.
struct ShaftCentrifugalRingGrowth : RingGrowthAtSpeed {
  static constexpr Form form = Form::shaft;
  static constexpr std::string_view mechanism =
      "Centrifugal force expands the inner rings. The contact angles then fall and the "
      "preload rises with the square of speed, without delay.";
  static constexpr std::string_view formula =
      "in the equilibrium of the sets, the radius of the inner raceway grows by c (n/10000 "
      "rpm)^2 (n: speed, c: growth at 10000 rpm)";
  static constexpr std::string_view source =
      "derived; c lies between the growth of a thin rotating ring, rho w^2 r^3/E, and of a "
      "solid disc, (1 - nu)/4 of this value (rho: density, w: angular speed, r: radius, E: "
      "elastic modulus, nu: Poisson's ratio)";
  static constexpr std::array<std::string_view, 4> confused_with{
      "thermal-preload", "shaft-contraction", "interference-fit", "mounting"};
  static constexpr std::array parameters{Parameter{.name = "growth_at_10000_rpm_um",
                                                   .unit = "um",
                                                   .initial = 1.0,
                                                   .lower = 0.0,
                                                   .upper = 30.0,
                                                   .plausible_lower = 0.1,
                                                   .plausible_upper = 8.0}};
  static constexpr std::array needs{Need::speed_levels, Need::preload_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.radial_growth += at_speed(values[0] * um, in.point.speed);
  }
};

}  // namespace raceway::effects
