#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "effects/effect.h"
#include "friction/skf.h"

namespace raceway::effects {

/// Friction moment of asperity contact in mixed lubrication [N m].
///
///   M = μ φ_bl S1 d_m^0.26 (F_r^(4/3) + S2 F_a^(4/3)),   φ_bl = exp(-2.6e-8 (ν n)^1.4 d_m)
///
/// The formula is in its published units: M [N mm], d_m [mm], radial and axial load F_r and F_a
/// [N], viscosity ν [mm²/s], speed n [rpm]. The code converts these units. φ_bl is the share of
/// boundary lubrication. μ is the coefficient of boundary friction minus the coefficient of
/// full-film friction; the usual range of μ is 0.05 to 0.12. d_m is the mean of bore and outer
/// diameter.
/// Source:   sliding moment in [SKFGeneral, p. 91-101], with φ_bl, S1 = 1.30e-2 and S2 = 0.68. S1
///           and S2 are for a contact angle of 40 deg, see friction/skf.h.
/// Domain:   speed >= 0; φ_bl is 1 at standstill and 0 with a full film.
struct MixedLubrication {
  static constexpr std::string_view id = "mixed-lubrication";
  static constexpr std::string_view title = "mixed lubrication at low speed";
  static constexpr std::string_view mechanism =
      "At low speed or low viscosity, the film does not separate the surfaces, and their "
      "asperities touch. The friction then decreases with speed, as on the left branch of "
      "the Stribeck curve.";
  static constexpr std::string_view formula =
      "M = mu exp(-2.6e-8 (nu n)^1.4 d_m) 0.013 d_m^0.26 (F_r^(4/3) + 0.68 F_a^(4/3)), with "
      "the moment M in N mm, the mean diameter d_m in mm, the viscosity nu in mm2/s, the "
      "speed n in rpm, and the radial and axial load F_r and F_a in N (mu: friction "
      "coefficient)";
  static constexpr std::string_view within_contacts =
      "mu_boundary under [friction], race_roughness_um under [bearing]";
  static constexpr std::string_view not_for_rollers =
      "the constants of the effect are for ball bearings";
  static constexpr std::string_view source =
      "sliding moment of the SKF general catalogue (2006), p. 91-101";
  static constexpr std::array<std::string_view, 3> confused_with{"seal-friction", "z",
                                                                 "load-exponent"};
  static constexpr std::string_view settled_by = "the same points with a second oil";
  static constexpr std::array parameters{Parameter{.name = "friction_coefficient",
                                                   .unit = "1",
                                                   .initial = 0.07,
                                                   .lower = 0.0,
                                                   .upper = 2.0,
                                                   .plausible_lower = 0.02,
                                                   .plausible_upper = 0.15}};
  static constexpr std::array needs{Need::speed_levels, Need::palmgren_law};
  static constexpr std::array<std::string_view, 2> bearing_data{"bore", "outer_diameter"};

  static double unit_moment(const MomentInputs& in) {
    const friction::BearingState<double>& s = in.state;
    const bearing::BearingGeometry& g = s.bearing->geometry();
    const friction::SkfConstants& c = friction::skf_angular_contact;
    const double d_m = friction::RingSize{g.bore, g.outer_diameter}.mean_diameter();
    return friction::boundary_share(s.speed, s.kinematic_viscosity, d_m) * c.S1 *
           std::pow(d_m / mm, 0.26) *
           (std::pow(s.radial_load, 4.0 / 3.0) +
            c.S2 * std::pow(std::abs(s.axial_load), 4.0 / 3.0)) *
           N_mm;
  }
};

}  // namespace raceway::effects
