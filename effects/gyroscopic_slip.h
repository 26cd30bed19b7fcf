#pragma once

#include <array>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Empirical moment that is proportional to the gyroscopic moments of the balls [N m].
///
///   M = c Σ M_g
///
/// M_g is the gyroscopic moment of one ball, c a fitted factor, and the sum is over all balls. The
/// effect can describe a residual that grows with the square of speed. M also grows with the load,
/// because M_g depends on the contact angle at the outer race.
///
/// M is not the friction moment of gyroscopic sliding. The axis of M_g is perpendicular to the
/// shaft, so the gyroscopic moments do not brake the shaft. Real sliding dissipates the power Σ M_f
/// ω_slip and therefore brakes the shaft with the moment Σ M_f ω_slip/ω (M_f: friction moment on a
/// ball, ω_slip: slip speed of the ball, ω: shaft speed). Sliding begins above the friction limit,
/// M_g > about μ Q D/2 (μ: friction coefficient, Q: contact load, D: ball diameter). This effect
/// has no such limit and no slip speed, and c is not a friction coefficient.
///
/// Source:   M_g [CaseStudy, eqs. 14 and 18; Harris2006, vol. 2, ch. 5]; M = c Σ M_g is empirical.
/// Domain:   converged equilibrium of the balls; otherwise M is NaN. M is zero at standstill.
struct GyroscopicSlip {
  static constexpr std::string_view id = "gyroscopic-slip";
  static constexpr std::string_view title =
      "a moment in proportion to the gyroscopic moment (empirical)";
  static constexpr std::string_view mechanism =
      "In angular contact the orbit turns the spin axis of each ball, which causes a gyroscopic "
      "moment proportional to the square of speed. The effect is empirical: its friction moment is "
      "proportional to the gyroscopic moment. The gyroscopic moment itself is perpendicular to the "
      "shaft and does not brake the shaft. A ball slides only above the friction limit; the "
      "program does not compute the power of this sliding.";
  static constexpr std::string_view formula =
      "M = c sum of M_g over the balls (M_g: gyroscopic moment of a ball, c: share): an "
      "empirical formula, not a friction law";
  static constexpr std::string_view within_contacts =
      "race_control = \"balanced\" under [solver], with which the ball rotation follows from the "
      "tractions";
  static constexpr std::string_view not_for_rollers =
      "the axes of cylindrical rollers are parallel to the shaft, without gyroscopic moment";
  static constexpr std::string_view source =
      "M_g by [CaseStudy, eqs. 14 and 18]; Harris and Kotzalas, vol. 2, ch. 5; M = c sum M_g is "
      "empirical, without a source";
  static constexpr std::array<std::string_view, 3> confused_with{"lubricant-drag", "spin-friction",
                                                                 "windage"};
  static constexpr std::string_view settled_by = "the same points with ceramic balls";
  static constexpr std::array parameters{Parameter{.name = "share",
                                                   .unit = "1",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.02,
                                                   .plausible_upper = 1.0}};
  static constexpr std::array needs{Need::loads, Need::speed_levels};
  static constexpr bool needs_equilibrium = true;
  static constexpr bool empirical = true;

  static double unit_moment(const MomentInputs& in) {
    const bearing::BearingEquilibrium* const e = in.state.equilibrium;
    if (e == nullptr || !e->report.converged()) return unset;
    double sum = 0.0;
    for (std::size_t k = 0; k < e->balls.distinct().size(); ++k)
      sum += e->balls.weight(k) * e->balls.distinct()[k].gyroscopic_moment;
    return sum;
  }
};

}  // namespace raceway::effects
