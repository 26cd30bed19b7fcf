#pragma once

#include <array>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Friction moment of balls that slide under their gyroscopic moment [N m].
///
///   M = c Σ M_g
///
/// Source:   M_g [CaseStudy, eqs. 14 and 18; Harris2006, vol. 2, ch. 5]; that a share c of it shows
///           up at the shaft is an assumption. No threshold: whether M_g exceeds what friction can
///           hold is not asked.
/// Domain:   converged equilibrium, else NaN; zero at standstill.
struct GyroscopicSlip {
  static constexpr std::string_view id = "gyroscopic-slip";
  static constexpr std::string_view title = "gyroscopic sliding of the balls";
  static constexpr std::string_view mechanism =
      "The axis of a ball in angular contact is turned as the ball orbits. The gyroscopic moment "
      "that resists makes the ball slide across the races, with the square of speed.";
  static constexpr std::string_view formula = "M = c sum of M_g over the balls";
  static constexpr std::string_view source =
      "M_g by [CaseStudy, eqs. 14 and 18]; Harris and Kotzalas, vol. 2, ch. 5; share c assumed";
  static constexpr std::array<std::string_view, 3> confused_with{"lubricant-drag", "spin-friction",
                                                                 "windage"};
  static constexpr std::array parameters{Parameter{.name = "share",
                                                   .unit = "1",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.02,
                                                   .plausible_upper = 1.0}};
  static constexpr std::array needs{Need::loads, Need::speed_levels};
  static constexpr bool needs_equilibrium = true;

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
