#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"
#include "friction/skf.h"

namespace raceway::effects {

/// Factor on the viscous moment that describes inlet shear heating [1].
///
///   1 / (1 + c 1.84e-9 (n d_m)^1.28 ν^0.64)      n [rpm], d_m [mm], ν [mm²/s]
///
/// n is the speed and ν the viscosity. c = 1 gives the published formula, see inlet_shear_factor()
/// in friction/skf.h.
/// Source:   [SKFGeneral, p. 91-101]. d_m is the mean of bore and outer diameter.
/// Domain:   speed >= 0, viscosity > 0. The factor is 1 at standstill.
struct InletShearHeating {
  static constexpr std::string_view id = "inlet-shear-heating";
  static constexpr std::string_view title = "shear heating in the inlet of the contacts";
  static constexpr std::string_view mechanism =
      "Only a small part of the lubricant in front of a ball passes through the contact; "
      "the rest flows back, is sheared and heats up. The film is therefore thinner than its "
      "viscosity at the bearing temperature suggests, most clearly at high speed.";
  static constexpr std::string_view formula =
      "M0 / (1 + c 1.84e-9 (n d_m)^1.28 nu^0.64) in place of the viscous moment M0 (c: "
      "strength, n: speed in rpm, d_m: mean of bore and outer diameter in mm, nu: viscosity "
      "in mm2/s)";
  static constexpr std::string_view within_contacts =
      "rolling_factor under [friction], which has its own thermal factor";
  static constexpr std::string_view not_for_rollers =
      "the constants of the effect are for ball bearings";
  static constexpr std::string_view source = "SKF general catalogue (2006), p. 91-101";
  static constexpr std::array<std::string_view, 4> confused_with{
      "film-self-heating", "shear-thinning", "replenishment-starvation", "viscous-exponent"};
  static constexpr std::string_view settled_by = "the same points with a second oil";
  static constexpr std::array parameters{Parameter{.name = "strength",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.0,
                                                   .upper = 20.0,
                                                   .plausible_lower = 0.2,
                                                   .plausible_upper = 3.0}};
  static constexpr std::array needs{Need::speed_levels, Need::palmgren_law};
  static constexpr std::array<std::string_view, 2> bearing_data{"bore", "outer_diameter"};

  static void lubricant(const LubricantInputs& in, std::span<const double> values, Film& film) {
    const bearing::BearingGeometry& g = in.state.bearing->geometry();
    const double published =
        friction::inlet_shear_factor(in.state.speed, film.kinematic_viscosity,
                                     friction::RingSize{g.bore, g.outer_diameter}.mean_diameter());
    film.viscous_share /= 1.0 + values[0] * (1.0 / published - 1.0);
  }
};

}  // namespace raceway::effects
