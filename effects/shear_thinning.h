#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Factor on the viscous moment for a shear-thinning lubricant [1].
///
///   (1 + (n/n_c)²)^-p
///
/// n is the speed, n_c the speed at which the thinning begins, and p a fitted exponent.
/// Source:   Carreau's formula for viscosity as a function of shear rate, with a shear rate
///           proportional to speed. p is (1 - m)/2 times the exponent of the viscosity in the
///           viscous moment, where m is the flow index of the lubricant (1 without thinning). m of
///           0.6 to 0.9 gives p up to about 0.15.
/// Domain:   speed >= 0, n_c > 0.
struct ShearThinning {
  static constexpr std::string_view id = "shear-thinning";
  static constexpr std::string_view title = "lubricant that thins under shear";
  static constexpr std::string_view mechanism =
      "Above a certain shear rate, the thickener or the polymers of a lubricant align with the "
      "flow, and the viscosity falls.";
  static constexpr std::string_view formula =
      "M0 (1 + (n/n_c)^2)^-p in place of the viscous moment M0 (n: speed, n_c: critical "
      "speed, p: exponent)";
  static constexpr std::string_view source =
      "Carreau's law with a shear rate proportional to speed";
  static constexpr std::array<std::string_view, 4> confused_with{
      "inlet-shear-heating", "replenishment-starvation", "film-self-heating", "viscous-exponent"};
  static constexpr std::string_view settled_by = "the same points with a second oil";
  static constexpr std::array parameters{Parameter{.name = "exponent",
                                                   .unit = "1",
                                                   .initial = 0.08,
                                                   .lower = 0.0,
                                                   .upper = 0.3,
                                                   .plausible_lower = 0.02,
                                                   .plausible_upper = 0.2},
                                         Parameter{.name = "critical_speed_rpm",
                                                   .unit = "rpm",
                                                   .initial = 5000.0,
                                                   .lower = 1000.0,
                                                   .upper = 20000.0,
                                                   .plausible_lower = 1000.0,
                                                   .plausible_upper = 20000.0,
                                                   .neutral = unset}};
  static constexpr std::array needs{Need::speed_levels};

  static void lubricant(const LubricantInputs& in, std::span<const double> values, Film& film) {
    const double ratio = in.state.speed / (values[1] * rpm);
    film.viscous_share *= std::pow(1.0 + ratio * ratio, -values[0]);
  }
};

}  // namespace raceway::effects
