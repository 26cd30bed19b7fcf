#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Tilt of the inner ring that the shaft imposes [rad].
///
///   θ_z -> θ_z + c
///
/// θ_z is the tilt about the z axis, and c the added tilt. The contact angles and loads of the
/// balls then vary around the ring.
/// Source:   definition; 1 to 5 arcmin (0.3 to 1.5 mrad) are usual tolerances of housings.
/// Domain:   small angles. Without radial load, the sign of c has no influence.
struct Misalignment {
  static constexpr std::string_view id = "misalignment";
  static constexpr std::string_view title = "tilted inner ring";
  static constexpr std::string_view mechanism =
      "Misaligned shaft and housing bores tilt the rings against each other. The loads and contact "
      "angles then differ from ball to ball.";
  static constexpr std::string_view formula =
      "in the equilibrium of the balls, the inner ring is tilted by c about the z axis";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 3> confused_with{"z", "load-offset",
                                                                 "spin-friction"};
  static constexpr std::array parameters{Parameter{.name = "tilt_mrad",
                                                   .unit = "mrad",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 3.0,
                                                   .plausible_lower = 0.1,
                                                   .plausible_upper = 1.5}};
  static constexpr std::array needs{Need::loads, Need::ball_load_law};
  // The equilibrium of the sets on a shaft is solved without tilt.
  static constexpr bool friction_alone = true;

  static void condition(const ConditionInputs&, std::span<const double> values, Condition& c) {
    c.tilt += values[0] * mrad;
  }
};

}  // namespace raceway::effects
