#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"
#include "friction/skf.h"

namespace raceway::effects {

/// Factor on the viscous moment that describes replenishment starvation [1].
///
///   exp(-K ν n (d + D) sqrt(K_Z / (2 (D - d))))      ν [mm²/s], n [rpm], d and D [mm], K_Z = 4.4
///
/// ν is the viscosity, n the speed, d the bore and D the outer diameter; see replenishment_factor()
/// in friction/skf.h.
/// Source:   [SKFGeneral, p. 91-101]: K = 3e-8 for an oil bath of low level or an oil jet, 6e-8 for
///           grease and oil-air.
///           K_Z is the value for SKF single row angular contact bearings, see friction/skf.h.
/// Domain:   speed >= 0. The formula is not for an oil bath, because the model assumes that a bath
///           floods the contacts. Enter an oil bath with a low level as an oil jet, which has the
///           same K.
struct ReplenishmentStarvation {
  static constexpr std::string_view id = "replenishment-starvation";
  static constexpr std::string_view title = "starvation: lubricant flows back too slowly";
  static constexpr std::string_view mechanism =
      "Each ball pushes the lubricant aside. If the next ball comes before the lubricant has "
      "flowed back, the film is thinner and has less drag.";
  static constexpr std::string_view formula =
      "M0 exp(-K nu n (d + D) sqrt(4.4 / (2 (D - d)))) in place of the viscous moment M0 "
      "(K: K_rs, nu: viscosity in mm2/s, n: speed in rpm, d and D: bore and outer diameter "
      "in mm)";
  static constexpr std::string_view within_contacts = "K_rs under [friction]";
  static constexpr std::string_view not_for_rollers =
      "the constants of the effect are for ball bearings";
  static constexpr std::string_view source = "SKF general catalogue (2006), p. 91-101";
  static constexpr std::array<std::string_view, 4> confused_with{
      "inlet-shear-heating", "film-self-heating", "shear-thinning", "viscous-exponent"};
  static constexpr std::string_view settled_by = "the same points with more oil";
  static constexpr std::array parameters{Parameter{.name = "K_rs",
                                                   .unit = "1",
                                                   .initial = 3e-8,
                                                   .lower = 0.0,
                                                   .upper = 1e-6,
                                                   .plausible_lower = 0.5e-8,
                                                   .plausible_upper = 12e-8}};
  static constexpr std::array needs{Need::speed_levels, Need::palmgren_law};
  static constexpr std::array<std::string_view, 2> bearing_data{"bore", "outer_diameter"};
  static constexpr std::array supplies{friction::Supply::oil_air, friction::Supply::grease,
                                       friction::Supply::jet};

  static void lubricant(const LubricantInputs& in, std::span<const double> values, Film& film) {
    const bearing::BearingGeometry& g = in.state.bearing->geometry();
    film.viscous_share *= friction::replenishment_factor(
        values[0], in.state.speed, film.kinematic_viscosity,
        friction::RingSize{g.bore, g.outer_diameter}, friction::skf_angular_contact.K_Z);
  }
};

}  // namespace raceway::effects
