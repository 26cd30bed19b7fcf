#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Air drag on shaft, cage and balls [N m].
///
///   M = c (n/10 000 rpm)^1.8
///
/// c is the moment at 10 000 rpm. M is the moment of one bearing. In a coast-down, however, M is
/// the moment of all rotating parts together, including a flywheel. M is then added once, not once
/// per bearing.
///
/// Source:   moment of a turning cylinder of radius R and length L in a gap, C_f π ρ ω² R⁴ L, with
///           the air density ρ and the friction coefficient C_f ~ Re^-0.2 (Bilgen and Boulos,
///           turbulent; Re: Reynolds number). The exponent is therefore 2 - 0.2; c is fitted.
/// Domain:   speed >= 0. Below a Reynolds number of about 10 000, the exponent of the speed
///           approaches 1.5.
struct Windage {
  static constexpr std::string_view id = "windage";
  static constexpr std::string_view title = "air friction";
  static constexpr std::string_view mechanism =
      "Shaft, cage and balls drag air through the gaps. The flow is turbulent, and the friction of "
      "the air grows a little more slowly than the square of speed. On a rig with coast-downs, the "
      "effect includes the air around the whole rotor.";
  static constexpr std::string_view formula =
      "M = c (n/10000 rpm)^1.8 (n: speed, c: moment at 10000 rpm)";
  static constexpr std::string_view source =
      "rotating cylinder in a gap, [BilgenBoulos1973]: friction coefficient ~ Re^-0.2; c is fitted";
  static constexpr std::array<std::string_view, 4> confused_with{
      "lubricant-drag", "centrifugal-ring-growth", "cage-friction", "gyroscopic-slip"};
  static constexpr std::string_view settled_by =
      "the torque while the oil supply is shut off for a minute";
  static constexpr std::array parameters{Parameter{.name = "torque_at_10000_rpm_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 10.0,
                                                   .lower = 0.0,
                                                   .upper = 1e5,
                                                   .plausible_lower = 0.1,
                                                   .plausible_upper = 200.0}};
  static constexpr double size_power = 5.0;
  static constexpr std::array needs{Need::speed_levels};
  static constexpr bool drags_on_the_rotor = true;

  static double unit_moment(const MomentInputs& in) {
    if (!(in.state.speed > 0.0)) return 0.0;
    return std::pow(in.state.speed / (10000.0 * rpm), 1.8) * N_mm;
  }
};

}  // namespace raceway::effects
