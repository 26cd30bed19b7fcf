#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Additional moment that corrects the exponent of speed and viscosity in the viscous moment [N m]:
///
///   M = M0 ((max(ν n, 2000)/300000)^e - 1)        ν n in mm²/s rpm
///
/// e is the fitted change of the exponent. M0 is the viscous moment of the friction law, which is
/// proportional to f0 (ν n)^(2/3) with the kinematic viscosity ν and the speed n. M0 + M is
/// proportional to (ν n)^(2/3 + e). M is zero at ν n = 300 000 mm²/s rpm, a medium value for
/// spindle bearings. This reference value makes e nearly independent of the factor f0 in a fit.
/// Source:   form of the formula: [Palmgren1959]. Exponents of 0.55 to 0.75 instead of 2/3 are
///           assumed, so e is -0.12 to 0.08.
/// Domain:   speed >= 0; M is constant below ν n = 2000, like Palmgren's M0.
struct ViscousExponent {
  static constexpr std::string_view id = "viscous-exponent";
  static constexpr std::string_view title = "a different exponent of the viscous moment";
  static constexpr std::string_view mechanism =
      "The exponent 2/3 of speed and viscosity is a mean over many bearings. A slightly "
      "wrong exponent looks like missing physics over the whole range of speeds.";
  static constexpr std::string_view formula =
      "M0 (nu n / 300000)^e in place of the viscous moment M0 (nu: viscosity in mm2/s, n: "
      "speed in rpm, e: exponent_change)";
  static constexpr std::string_view within_contacts =
      "rolling_factor under [friction], whose exponents follow from the contacts";
  static constexpr std::string_view source =
      "form of Palmgren's law, Ball and Roller Bearing Engineering, 3rd ed.; the usual "
      "range is assumed";
  static constexpr std::array<std::string_view, 4> confused_with{
      "f0", "cage-friction", "inlet-shear-heating", "replenishment-starvation"};
  static constexpr std::string_view settled_by = "the same points with a second oil";
  static constexpr std::array parameters{Parameter{.name = "exponent_change",
                                                   .unit = "1",
                                                   .initial = 0.0,
                                                   .lower = -0.4,
                                                   .upper = 0.4,
                                                   .plausible_lower = -0.12,
                                                   .plausible_upper = 0.09}};
  static constexpr std::array needs{Need::speed_levels};
  static constexpr bool base_law = true;

  static double moment(const MomentInputs& in, std::span<const double> values) {
    const double nu_n = (in.state.kinematic_viscosity / mm2_per_s) * (in.state.speed / rpm);
    return in.base.viscous *
           (std::pow(std::max(nu_n, 2000.0) / friction::medium_nu_n, values[0]) - 1.0);
  }
};

}  // namespace raceway::effects
