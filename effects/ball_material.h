#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Balls of the other material: silicon nitride if the model has steel, and steel if the model has
/// silicon nitride.
///
///   X = (1 - c) X_entered + c X_other       X: density, elastic modulus, Poisson's ratio
///
/// Source:   definition. c is the share of the other material; c = 1 means that the model has the
///           wrong ball material. Values between 0 and 1 have no physical meaning; they occur
///           during a fit.
/// Domain:   0 <= c <= 1. The effect changes the torque because the density changes the centrifugal
///           force and gyroscopic moment of the balls, and the modulus changes the contact areas.
///
/// For the bearing sets of a shaft, the effect assumes that the bearings were mounted with balls of
/// the other material. A preload given as a force remains unchanged, because this force was set at
/// mounting. A preload given as an offset or a class fixes the gap between the ring faces, so
/// stiffer balls increase the preload force.
struct BallMaterial {
  static constexpr std::string_view id = "ball-material";
  static constexpr std::string_view title = "the ball material differs from the entered material";
  static constexpr std::string_view mechanism =
      "Ceramic balls have 0.41 times the mass of steel balls and are stiffer. At speed, ceramic "
      "balls load the outer race less and have a smaller gyroscopic moment.";
  static constexpr std::string_view formula =
      "X = (1 - c) X_entered + c X_other for density, elastic modulus and Poisson's ratio "
      "of the balls (c: share)";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 4> confused_with{
      "elastic-hysteresis", "gyroscopic-slip", "spin-friction", "preload_N"};
  static constexpr std::array parameters{Parameter{.name = "share",
                                                   .unit = "1",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.8,
                                                   .plausible_upper = 1.0}};
  static constexpr std::array needs{Need::loads, Need::ball_load_law};
  static constexpr std::string_view not_for_rollers = "there are no balls";

  static void condition(const ConditionInputs&, std::span<const double> values, Condition& c) {
    c.other_balls += values[0];
  }
};

}  // namespace raceway::effects
