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

/// Returns the oil at the temperature and viscosity in `state`. An effect may have changed either
/// value.
[[nodiscard]] OilState oil_of(const BearingState<double>& state);

/// Friction at the contacts of one ball. `inner` or `outer` is empty if the ball does not touch
/// this race.
struct BallFriction {
  std::optional<ContactFriction> inner, outer;
};

/// Friction of a bearing by the contact law, with further results.
struct ContactResult {
  BearingFriction friction;
  double drag = 0.0;  ///< drag of the balls in the lubricant [N m]
  /// Mean sliding speed of all contacts, weighted with the pressure p: Σ p |v|/Σ Q [m/s].
  double mean_slip = unset;
  /// Friction force that balances the gyroscopic moment, divided by the contact load: largest value
  /// of all contacts [1].
  double holding_coefficient = unset;
  /// Friction force that balances the gyroscopic moment, divided by the friction of film and
  /// asperities in the contact: largest value of all contacts [1].
  double holding_over_traction = unset;

  [[nodiscard]] double moment() const { return friction.moment() + drag; }  ///< [N m]
  /// Returns the rolling resistance of the oil as `viscous`, and the sum of all other moments as
  /// `load`.
  [[nodiscard]] BaseMoments<double> moments() const {
    return {.load = sliding() + hysteresis() + drag, .viscous = rolling()};
  }
  /// True if rescale() can convert a result from the parameter values `from` to the values `to`.
  /// Only the factors of rolling and hysteresis may differ, and a changed factor must not be 0 in
  /// `from`.
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

/// Heat of each ring [W]: the power of its contacts, plus half of the drag losses of the balls.
[[nodiscard]] HeatSplit ring_heat(const ContactResult& result, double speed);

/// Returns the friction of a bearing, summed over its balls. Sliding, rolling and hysteresis are
/// NaN without a converged equilibrium. If `balls` is not null, it receives the friction at the
/// contacts of each ball in Balls::distinct(), with one entry for balls that are equal by symmetry.
[[nodiscard]] ContactResult contact_result(const BearingState<double>& state,
                                           std::span<const double> values,
                                           std::vector<BallFriction>* balls = nullptr);

/// Drag moment of the balls in the mixture of oil and air [N m].
///
///   M = Z (C_D/2) ρ c (π D²/4) (ω_m d_m/2)³/ω,   C_D = 0.45
///
/// ρ is `density`, the density of the oil. c is `oil_fraction`, the share of oil in the free space
/// of the bearing. ω is the shaft speed, ω_m the orbital speed of the Z balls.
/// Source:   drag of a sphere at high Reynolds number, c as in commercial programs; from memory,
///           not checked against a print.
/// Domain:   speed > 0; the moment is 0 at standstill. Accuracy: the moment is accurate to a factor
///           of 3. The drag of the cage is not included.
[[nodiscard]] double ball_drag(const BearingState<double>& state, double density,
                               double oil_fraction);

}  // namespace raceway::friction::contact
