#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "effects/effect.h"
#include "friction/palmgren.h"

namespace raceway::effects {

/// Additional moment that corrects the load exponent in the load moment [N m]:
///
///   M = M1 ((P0/200 N)^e - 1)      or, with the option f1_load = "F_b",  M1 ((F_b/1000 N)^e - 1)
///
/// M1 is the load moment of the friction law. P0 is the equivalent static load, and F_b the load in
/// M1 = f1 F_b d_m (friction/palmgren.h). With M added, the load exponent y of the friction law
/// becomes y + e. M is zero at a medium load of spindle bearings: P0 = 200 N, or F_b = 1000 N. With
/// this reference load, the fitted e hardly depends on the fitted factor z in f1 = z (P0/C0)^y.
/// Source:   form of the formula: [Palmgren1959]. The true exponent is assumed to be 0.25 to 0.55
///           instead of y = 0.33, so e is -0.08 to 0.22.
/// Domain:   every load; M is zero without load.
struct LoadExponent {
  static constexpr std::string_view id = "load-exponent";
  static constexpr std::string_view title = "a different exponent of the load moment";
  static constexpr std::string_view mechanism =
      "The exponent of the load in the load moment is a mean over many bearings. A slightly "
      "wrong exponent looks like missing physics over the whole range of loads.";
  static constexpr std::string_view formula =
      "M1 (P0 / 200 N)^e in place of the load moment M1 (P0: equivalent static load, e: "
      "exponent_change); with f1_load = \"F_b\": M1 (F_b / 1000 N)^e (F_b: load in M1 = f1 "
      "F_b d_m)";
  static constexpr std::string_view within_contacts =
      "rolling_factor under [friction], whose exponents follow from the contacts";
  static constexpr std::string_view not_for_rollers =
      "the load moment of rollers is in proportion to the load";
  static constexpr std::string_view source =
      "form of Palmgren's law, Ball and Roller Bearing Engineering, 3rd ed.; the usual "
      "range is assumed";
  static constexpr std::array<std::string_view, 5> confused_with{
      "z", "y", "differential-slip", "elastic-hysteresis", "load-offset"};
  static constexpr std::array parameters{Parameter{.name = "exponent_change",
                                                   .unit = "1",
                                                   .initial = 0.0,
                                                   .lower = -0.6,
                                                   .upper = 0.6,
                                                   .plausible_lower = -0.1,
                                                   .plausible_upper = 0.25}};
  static constexpr std::array needs{Need::load_levels};
  static constexpr bool base_law = true;

  static double moment(const MomentInputs& in, std::span<const double> values) {
    const double load = friction::f1_load(in.state);
    if (!(load > 0.0)) return 0.0 * load;
    return in.base.load *
           (std::pow(load / friction::medium_load(in.state.f1_load), values[0]) - 1.0);
  }
};

}  // namespace raceway::effects
