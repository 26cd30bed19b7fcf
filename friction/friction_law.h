#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "friction/palmgren.h"
#include "friction/powers.h"
#include "friction/skf.h"
#include "friction/state.h"

namespace raceway::friction {

/// Base law of a model. `contact` sums friction over the balls in equilibrium
/// (friction/contact/contact_law.h). `table` interpolates a measured or precomputed table
/// (friction/torque_table.h). `powers` and `contact_powers` are power laws of viscosity, speed and
/// load whose exponents are fitted to measurements (friction/powers.h). `palmgren`, `skf` and
/// `powers` are formulas for the whole bearing. The laws of cylindrical roller bearings are in
/// friction/roller_friction.h. In files, the roller laws are also named `palmgren` and `skf`; the
/// type of the bearing selects the law.
enum class FrictionLaw {
  palmgren,
  skf,
  contact,
  table,
  powers,
  contact_powers,
  roller_palmgren,
  roller_skf
};
/// Laws of ball bearings.
inline constexpr std::array all_friction_laws{FrictionLaw::palmgren, FrictionLaw::skf,
                                              FrictionLaw::contact,  FrictionLaw::table,
                                              FrictionLaw::powers,   FrictionLaw::contact_powers};
/// Laws of cylindrical roller bearings.
inline constexpr std::array roller_friction_laws{FrictionLaw::roller_palmgren,
                                                 FrictionLaw::roller_skf};
[[nodiscard]] constexpr bool of_rollers(FrictionLaw law) {
  return law == FrictionLaw::roller_palmgren || law == FrictionLaw::roller_skf;
}
/// True for `powers` and `contact_powers`, whose viscous moment has fitted exponents of speed,
/// viscosity and load. Such a law describes measurements without a physical explanation.
[[nodiscard]] constexpr bool has_fitted_exponents(FrictionLaw law) {
  return law == FrictionLaw::powers || law == FrictionLaw::contact_powers;
}
/// True if the law contains Palmgren's load moment (PalmgrenLoad) and has the parameters f0, z and
/// y.
[[nodiscard]] constexpr bool has_palmgren_load(FrictionLaw law) {
  return law == FrictionLaw::palmgren || has_fitted_exponents(law);
}
/// Returns all laws of roller bearings if `law` is a roller law, otherwise all laws of ball
/// bearings.
[[nodiscard]] constexpr std::span<const FrictionLaw> laws_of_same_bearing(FrictionLaw law) {
  if (of_rollers(law)) return roller_friction_laws;
  return all_friction_laws;
}

[[nodiscard]] std::string_view name(FrictionLaw law);
/// Returns the law of ball bearings with this name in files; nullopt for other names.
[[nodiscard]] std::optional<FrictionLaw> find_friction_law(std::string_view name);

/// Returns the name of an F1Load in files: "P0", "F_b", "F_r" or "rollers".
[[nodiscard]] std::string_view name(F1Load load);

/// Parameters of the law, in the order of the values that base_moments() expects.
///   palmgren: f0, z, y        skf: mu_bl, mu_EHL, K_rs        contact: contact_parameters
///   table: scale              powers, contact_powers: f0, z, y, viscous_exponent,
///                                                     viscous_load_exponent
///   roller_palmgren: f0, f1   roller_skf: mu_bl, mu_EHL, K_rs
[[nodiscard]] std::span<const Parameter> parameters(FrictionLaw law);

/// True if the key of the parameter `number` of a friction law is in the table [lubricant] of a
/// model file, not in [friction]. This is true only for `limiting_traction`.
[[nodiscard]] bool of_the_lubricant(const Parameter& number);

/// Returns the bearing data on which the moments of a friction law depend, named by the keys of a
/// model file without the unit at the end.
///   palmgren, powers: contact_angle, pitch_diameter, static_load_rating
///   skf:      ball_material (its density), bore, outer_diameter
/// The list is empty for `table`, because this law uses no bearing data. The list is also empty for
/// `contact`, `contact_powers` and the roller laws, because these laws can use all bearing data.
[[nodiscard]] std::span<const std::string_view> bearing_data(FrictionLaw law);

/// True if the law uses the equilibrium of the balls. The moments of such a law are NaN without a
/// converged equilibrium.
[[nodiscard]] constexpr bool needs_equilibrium(FrictionLaw law) {
  return law == FrictionLaw::contact || law == FrictionLaw::contact_powers;
}

/// Throws std::invalid_argument if the bearing does not have the data that the law needs. Laws with
/// Palmgren's load moment need the static load rating C0. The SKF law needs a contact angle above
/// 0. The functions that compute the moments do not check these data.
void require_data(FrictionLaw law, const bearing::Bearing& bearing);

/// Friction moments of the base law [N m]. For `palmgren`, `powers` and `contact_powers`, `load` is
/// the load-dependent moment and `viscous` the viscous moment. For SKF, `load` is the sliding
/// moment and `viscous` the rolling moment. For the contact law, `viscous` is the rolling
/// resistance of the oil and `load` contains all other moments. For a table, `load` is the
/// load-dependent part of the moment, and `viscous` is the rest of the moment.
template <typename T>
struct BaseMoments {
  T load;
  T viscous;
};

/// Friction moments of a cylindrical roller bearing by a law such as roller-palmgren. Moments that
/// depend on the roller loads are NaN without a converged equilibrium.
[[nodiscard]] BaseMoments<double> roller_moments(FrictionLaw law, const BearingState<double>& state,
                                                 std::span<const double> values);

/// Moments of the law `table`; NaN without a table.
[[nodiscard]] BaseMoments<double> table_moments(const BearingState<double>& state,
                                                std::span<const double> values);

/// Moments of the law `contact-powers`; NaN without a converged equilibrium.
[[nodiscard]] BaseMoments<double> contact_powers_moments(const BearingState<double>& state,
                                                         std::span<const double> values);

namespace contact {
/// Moments of the law `contact`; NaN without a converged equilibrium.
[[nodiscard]] BaseMoments<double> contact_moments(const BearingState<double>& state,
                                                  std::span<const double> values);
}  // namespace contact

template <typename T>
BaseMoments<T> base_moments(FrictionLaw law, const BearingState<T>& state,
                            std::span<const T> values) {
  if constexpr (std::is_same_v<T, double>) {
    if (law == FrictionLaw::contact) return contact::contact_moments(state, values);
    if (law == FrictionLaw::contact_powers) return contact_powers_moments(state, values);
    if (law == FrictionLaw::table) return table_moments(state, values);
    if (of_rollers(law)) return roller_moments(law, state, values);
  }
  if (has_palmgren_load(law))
    return {PalmgrenLoad::moment(state, values[1], values[2]),
            law == FrictionLaw::palmgren
                ? PalmgrenViscous::moment(state, values[0])
                : PowersViscous::moment(state, values[0], values[3], values[4])};
  return {SkfSliding::moment(state, values[0], values[1]), SkfRolling::moment(state, values[2])};
}

}  // namespace raceway::friction
