#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Preload of a pair that shares the entered load [N].
///
///   F1 - F2 = F_a,   F2 = P - (1 - s) F_a,  not below zero
///   F_a -> (F1^(4/3) + F2^(4/3))^(3/4)
///
/// Source:   two springs that press against each other [Harris2006, vol. 1, ch. 9], derived: s is
///           1/2 for equally stiff bearings, 1 where a soft spring preloads the
///           second one. The 4/3 belongs to Palmgren's load moment with y = 1/3.
/// Domain:   P >= 0, 1/2 <= s <= 1. From F_a = P/(1 - s) on the second bearing is free of load. A
///           rigid pair, whose displacement goes with F^(2/3), is met by s of about 0.6.
/// Accuracy: exact for the sum of both load moments with y = 1/3, of other laws and of effects that
///           use ball loads an average over both bearings.
/// Trap:     z counts every bearing at the load of the set, as without this effect: it is half of
///           the z of one bearing.
struct SetPreload {
  static constexpr std::string_view id = "set-preload";
  static constexpr Form form = Form::rig;
  static constexpr std::string_view title = "a preload of the set that was not entered";
  static constexpr std::string_view datum = "the preload of the set";
  static constexpr std::string_view mechanism =
      "Not physics but a datum: the bearings press against each other, and the recorded load is "
      "shared between them. It shows where the recorded load is smaller than the preload.";
  static constexpr std::string_view formula =
      "F_a = F1 - F2 with F2 = P - (1 - s) F_a; (F1^(4/3) + F2^(4/3))^(3/4) in place of F_a";
  static constexpr std::string_view source =
      "two springs that press against each other (Harris, vol. 1, ch. 9), derived";
  static constexpr std::array<std::string_view, 4> confused_with{"torque-offset", "seal-friction",
                                                                 "load-offset", "load-exponent"};
  static constexpr std::string_view settled_by =
      "the preload of the set, by its axial deflection under a known load";
  static constexpr std::array parameters{Parameter{.name = "preload_N",
                                                   .unit = "N",
                                                   .initial = 500.0,
                                                   .lower = 0.0,
                                                   .upper = 1e5,
                                                   .plausible_lower = 20.0,
                                                   .plausible_upper = 1500.0},
                                         Parameter{.name = "share_on_the_first",
                                                   .unit = "1",
                                                   .initial = 0.75,
                                                   .lower = 0.5,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.5,
                                                   .plausible_upper = 1.0,
                                                   .neutral = unset}};
  static constexpr double size_power = 2.0;
  static constexpr std::array needs{Need::several_bearings, Need::load_levels};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    const double load = std::abs(in.point.axial_load);
    const double relieved = values[0] - (1.0 - values[1]) * load;
    if (!(relieved > 0.0)) return;
    const double both = std::pow(load + relieved, 4.0 / 3.0) + std::pow(relieved, 4.0 / 3.0);
    c.extra_axial_load += std::pow(both, 0.75) - load;
  }

  static std::string correction(std::span<const double> values) {
    return fmt::format("a preload of {:.3g} N that shares the recorded load", values[0]);
  }
};

}  // namespace raceway::effects
