#pragma once

#include <cmath>

#include "bearing/balls.h"
#include "bearing/bearing.h"
#include "model/spindle.h"
#include "record/units.h"

namespace raceway::spindle {

/// Returns a typical thermal conductance from ring to ring through the lubricant of a rotating ball
/// bearing [W/K]. Add this conductance to the conductance of the ball contacts.
///
///   G = 1650 Z D²      Z balls of diameter D [m]
///
/// Source:   590 Z D² sqrt(7 + ln(ω d_m/(2000 D))) of [Schaefer1993] as implemented in the open
///           program Thermca, evaluated at n d_m = 500 000 mm/min. ω is the speed [rad/s], n the
///           speed in rpm, and d_m the pitch diameter. The source formula includes the conductance
///           of the ball contacts, which is about a tenth of G. The sum of G and the conductance of
///           the ball contacts is therefore about a tenth too high.
/// Domain:   balls of 5 to 22 mm. If n d_m is from 200 000 to 2 000 000 mm/min, G differs from the
///           source formula by at most 12 %.
/// Accuracy: unknown. For a 7014 bearing, the contact model of [Jungnickel2010] in Thermca gives
///           0.6 W/K, and 1650 Z D² gives 4.7 W/K. The value 4.7 W/K agrees with the rule of thumb
///           that inner rings are 5 to 10 K warmer than outer rings.
[[nodiscard]] inline double usual_lubricant_conductance(const bearing::BearingGeometry& g) {
  constexpr double film = 1650.0;
  return film * g.ball_count * g.ball_diameter * g.ball_diameter;
}

/// Returns the thermal conductivity of balls or rollers [W/(m K)]: 30 for silicon nitride,
/// otherwise the conductivity of the rings. A density below 6000 kg/m³ identifies silicon nitride.
[[nodiscard]] inline double conductivity_of_element(const bearing::Material& material) {
  return material.density < 6000.0 ? 30.0 : model::steel_of_rings.conductivity;
}

/// Heat conduction from ring to ring through the balls of a bearing.
///
///   G = Z/(R_i + R_o),   R = K(k)/(2 π a) (1/λ_ball + 1/λ_ring) = R(1 N)/Q^(1/3)
///
/// Z is the number of balls, R_i and R_o are the resistances R of the contacts at inner and outer
/// ring, λ is a thermal conductivity, and R(1 N) is R at a contact load of 1 N. K is the complete
/// elliptic integral of the first kind. Its modulus k, k² = 1 - b²/a², does not depend on the load,
/// because both semi-axes a >= b of the contact ellipse are proportional to the cube root of the
/// contact load Q.
/// Source:   constriction_resistance() with Hertz's semi-axes; the resistance of the ball itself is
///           neglected.
/// Domain:   loads >= 0. A ball that touches only one race has the conductance 0.
/// Accuracy: the formula applies to a dry bearing at rest. In operation, the lubricant and the
///           rolling balls conduct several times as much heat as the dry contacts: add
///           model::Spindle::lubricant_conductance.
class BallConduction {
 public:
  /// The conductivities of balls and rings are in W/(m K).
  BallConduction(const bearing::Bearing& bearing, double ball_conductivity,
                 double ring_conductivity)
      : count_(bearing.geometry().ball_count),
        inner_(of(bearing.contact(bearing::Race::inner), ball_conductivity, ring_conductivity)),
        outer_(of(bearing.contact(bearing::Race::outer), ball_conductivity, ring_conductivity)) {}

  /// Returns the thermal resistance of one contact at a contact load in N [K/W]; infinite without
  /// load.
  [[nodiscard]] double resistance(bearing::Race race, double load) const {
    return 1.0 / ((race == bearing::Race::inner ? inner_ : outer_) * std::cbrt(load));
  }
  /// Returns the thermal conductance through one ball [W/K]; 0 if a contact has no load. Loads are
  /// in N.
  [[nodiscard]] double ball(double inner_load, double outer_load) const {
    if (!(inner_load > 0.0) || !(outer_load > 0.0)) return 0.0;
    const double inner = inner_ * std::cbrt(inner_load), outer = outer_ * std::cbrt(outer_load);
    return inner * outer / (inner + outer);
  }
  /// Returns the thermal conductance of a bearing whose balls have equal contact loads [W/K].
  [[nodiscard]] double conductance(double inner_load, double outer_load) const {
    return count_ * ball(inner_load, outer_load);
  }
  /// Returns the thermal conductance of a bearing with the contact loads in `balls` [W/K].
  [[nodiscard]] double conductance(const bearing::Balls& balls) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < balls.distinct().size(); ++k)
      sum += balls.weight(k) * ball(balls.distinct()[k].inner_load, balls.distinct()[k].outer_load);
    return sum;
  }

 private:
  /// Returns the thermal conductance of a contact at a load of 1 N [W/(K N^(1/3))].
  static double of(const bearing::HertzContact& contact, double ball, double ring) {
    return 2.0 * pi * contact.semi_major_axis(1.0) /
           (contact.first_integral * (1.0 / ball + 1.0 / ring));
  }

  double count_, inner_, outer_;
};

}  // namespace raceway::spindle
