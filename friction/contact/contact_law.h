#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "friction/contact/contact_data.h"
#include "friction/contact/contact_friction.h"
#include "friction/friction_law.h"
#include "friction/heat.h"
#include "friction/state.h"

namespace raceway::friction::contact {

/// Parameters of the contact law. Arguments named `values` contain the parameters in this order.
inline constexpr std::array contact_parameters{
    Parameter{.name = "rolling_factor",
              .unit = "1",
              .initial = 1.0,
              .lower = 0.0,
              .upper = 5.0,
              .plausible_lower = 0.6,
              .plausible_upper = 1.6},
    Parameter{.name = "hysteresis_factor",
              .unit = "1",
              .initial = 1.0,
              .lower = 0.0,
              .upper = 30.0,
              .plausible_lower = 0.5,
              .plausible_upper = 3.0},
    Parameter{.name = "mu_boundary",
              .unit = "1",
              .initial = 0.10,
              .lower = 0.02,
              .upper = 0.3,
              .plausible_lower = 0.06,
              .plausible_upper = 0.15},
    Parameter{.name = "limiting_traction",
              .unit = "1",
              .initial = 0.06,
              .lower = 0.01,
              .upper = 0.2,
              .plausible_lower = 0.03,
              .plausible_upper = 0.09},
    Parameter{.name = "K_rs", .unit = "1", .initial = 0.0, .lower = 0.0, .upper = 1e-6},
    Parameter{.name = "oil_fraction", .unit = "1", .initial = 0.0, .lower = 0.0, .upper = 0.3}};

/// Returns the contact law with these parameter values. `values` has the order of
/// contact_parameters.
[[nodiscard]] ContactLaw contact_law(const ContactData& data, std::span<const double> values);

/// Returns the oil properties at the temperature and viscosity of the bearing state.
[[nodiscard]] OilState oil_of(const BearingState<double>& state);

/// Friction at the contacts of one ball with the inner and outer race; empty for a race that the
/// ball does not touch.
struct BallFriction {
  std::optional<ContactFriction> inner, outer;
};

/// Friction of a bearing by the contact law, with further results.
struct ContactResult {
  BearingFriction friction;
  double drag = 0.0;  ///< drag of the balls in the lubricant [N m]
  /// Mean sliding speed in all contacts [m/s], weighted with the pressure: sum of ∫ p |v| dA over
  /// all contacts, divided by the sum of the contact loads (p: pressure, v: sliding velocity, A:
  /// contact area).
  double mean_slip = unset;
  /// Friction force that balances the gyroscopic moment, divided by the contact load: largest ratio
  /// of all contacts [1].
  double holding_coefficient = unset;
  /// Friction force that balances the gyroscopic moment, divided by the total friction force of
  /// film and asperities: largest ratio of all contacts [1].
  double holding_over_traction = unset;

  [[nodiscard]] double moment() const { return friction.moment() + drag; }  ///< [N m]
  /// Returns the rolling resistance of the oil as `viscous`, and the sum of all other moments as
  /// `load`.
  [[nodiscard]] BaseMoments<double> moments() const {
    return {.load = sliding() + hysteresis() + drag, .viscous = rolling()};
  }
  /// True if rescale() can convert a result for the parameter values `from` into the result for
  /// `to`. Only the factors of rolling and hysteresis may differ between `from` and `to`, and a
  /// factor that differs must not be 0 in `from`.
  [[nodiscard]] static bool rescales(std::span<const double> from, std::span<const double> to);
  void rescale(std::span<const double> from, std::span<const double> to);
  /// Multiplies the rolling resistance of the oil by the factor `share` [1].
  void thin(double share) {
    friction.inner.rolling *= share;
    friction.outer.rolling *= share;
  }
  [[nodiscard]] double rolling() const { return friction.inner.rolling + friction.outer.rolling; }
  [[nodiscard]] double sliding() const { return friction.inner.sliding + friction.outer.sliding; }
  [[nodiscard]] double hysteresis() const {
    return friction.inner.hysteresis + friction.outer.hysteresis;
  }
};

/// Heat of each ring [W]: the power lost in the contacts of the ring, plus half of the drag losses
/// of the balls.
[[nodiscard]] HeatSplit ring_heat(const ContactResult& result, double speed);

/// Returns the friction of a bearing, summed over its balls. Sliding, rolling and hysteresis are
/// NaN without a converged equilibrium. If `balls` is not null, the function writes the friction at
/// the contacts of each ball in Balls::distinct() into this vector. Balls with equal contacts by
/// symmetry have one common entry.
[[nodiscard]] ContactResult contact_result(const BearingState<double>& state,
                                           std::span<const double> values,
                                           std::vector<BallFriction>* balls = nullptr);

/// Drag moment of the balls in the mixture of oil and air [N m].
///
///   M = Z (C_D/2) ρ c (π D²/4) (ω_m d_m/2)³/ω,   C_D = 0.45
///
/// ρ is the density of the oil, and c (`oil_fraction`) the share of the free volume of the bearing
/// that is filled with oil. ω is the shaft speed, Z the number of balls, and ω_m their orbital
/// speed. D is the ball diameter and d_m the pitch diameter.
/// Source:   drag of a sphere at high Reynolds number, with c as in commercial programs. No
///           publication was checked.
/// Domain:   speed > 0; the moment is 0 at standstill. Accuracy: the moment is accurate to a factor
///           of 3. The drag of the cage is not included.
[[nodiscard]] double ball_drag(const BearingState<double>& state, double density,
                               double oil_fraction);

}  // namespace raceway::friction::contact
