#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "bearing/rigid_preload.h"
#include "effects/effect.h"

namespace raceway::effects {

/// Equivalent axial load of two bearings that are preloaded against each other, under the entered
/// external load [N].
///
///   F1 = F2 + F_a,   F2 = P (u - 1)(u - 2)/2 - F_rigid(0) u (u - 2) + F_rigid(n) u (u - 1)/2
///   F_a -> (F1^(4/3) + F2^(4/3))^(3/4)
///
/// F_a is the external load, P the preload, and n the speed. F1 is the axial force on the bearing
/// to which F_a adds load. F2 is the axial force on the other bearing, from which F_a removes load.
/// F_rigid(n) is F2 in a rigid pair at the speed n (bearing/rigid_preload.h).
///
/// The parameter u interpolates between three kinds of preload. u = 0 is a soft spring that keeps
/// F2 at P. u = 1 is a rigid pair whose forces do not change with speed. u = 2 is a rigid pair
/// whose preload grows with speed.
///
/// Source:   two bearings that press against each other [Harris2006, vol. 1, ch. 9], derived. The
///           exponent 4/3 comes from Palmgren's load moment with the load exponent y = 1/3.
/// Domain:   P >= 0, 0 <= u <= 2. Two equal bearings under pure axial load.
/// Accuracy: the sum of the load moments of both bearings is exact if y = 1/3. For another y or
///           friction law, and for effects that use ball loads, the equivalent load is only an
///           average over both bearings.
/// Trap:     with the changed F_a, the friction law gives the sum of the load moments of both
///           bearings. For a rig with two bearings, the program multiplies this sum by two. The
///           fitted factor z of the load moment is therefore half of the z of one bearing.
struct SetPreload {
  static constexpr std::string_view id = "set-preload";
  static constexpr Form form = Form::rig;
  static constexpr std::string_view title = "a preload of the set that was not entered";
  static constexpr std::string_view datum = "the preload of the set";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the bearings are preloaded against each other and share "
      "the recorded load. The error is visible if the recorded load is smaller than the preload.";
  static constexpr std::string_view formula =
      "(F1^(4/3) + F2^(4/3))^(3/4) in place of the axial load F_a; F1 = F2 + F_a and F2 are "
      "the axial forces of the two bearings. F2 is the preload P for springs (mounting = "
      "0), F_rigid(0) for a rigid pair without influence of speed (mounting = 1), and "
      "F_rigid(n) for a rigid pair at the speed n (mounting = 2). Values between these "
      "three are interpolated";
  static constexpr std::string_view source =
      "two preloaded bearings (Harris, vol. 1, ch. 9), derived";
  static constexpr std::array<std::string_view, 4> confused_with{"torque-offset", "seal-friction",
                                                                 "load-offset", "load-exponent"};
  static constexpr std::string_view settled_by =
      "the preload of the set, from its axial deflection under a known load";
  static constexpr std::array parameters{Parameter{.name = "preload_N",
                                                   .unit = "N",
                                                   .initial = 500.0,
                                                   .lower = 0.0,
                                                   .upper = 1e5,
                                                   .plausible_lower = 20.0,
                                                   .plausible_upper = 1500.0},
                                         Parameter{.name = "mounting",
                                                   .unit = "1",
                                                   .initial = 2.0,
                                                   .lower = 0.0,
                                                   .upper = 2.0,
                                                   .plausible_lower = 0.0,
                                                   .plausible_upper = 2.0,
                                                   .neutral = unset}};
  static constexpr double size_power = 2.0;
  static constexpr std::array needs{Need::several_bearings, Need::several_axial_loads};
  static constexpr std::array<std::string_view, 8> bearing_data{
      "ball_count",       "ball_diameter",    "pitch_diameter", "contact_angle",
      "inner_conformity", "outer_conformity", "ball_material",  "ring_material"};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    const double preload = values[0], u = values[1];
    if (!(preload > 0.0)) return;
    const double load = std::abs(in.point.axial_load);
    const auto rigid = [&](double speed) {
      return bearing::relieved_thrust(in.bearing, preload, load, speed);
    };
    const double relieved = 0.5 * (u - 1.0) * (u - 2.0) * preload - u * (u - 2.0) * rigid(0.0) +
                            0.5 * u * (u - 1.0) * rigid(std::abs(in.point.speed));
    if (relieved <= 0.0) return;
    const double both = std::pow(load + relieved, 4.0 / 3.0) + std::pow(relieved, 4.0 / 3.0);
    c.extra_axial_load += std::pow(both, 0.75) - load;
  }

  static std::string correction(std::span<const double> values) {
    return fmt::format("a preload of {:.3g} N that shares the recorded load", values[0]);
  }
};

}  // namespace raceway::effects
