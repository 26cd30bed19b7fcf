#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Friction moment from churning of the oil bath [N m].
///
///   M = c (n/10 000 rpm)^0.621 (ν/20 mm²/s)^1.379
///
/// n is the speed, ν the viscosity, and c the moment at 10 000 rpm and 20 mm²/s.
/// Source:   exponents of the second term of the drag moment in the SKF catalogues from 2013 on,
///           1.093e-7 n² d_m³ (n d_m² f_t/ν)^-1.379 R_s. d_m is the pitch diameter. The factors f_t
///           and R_s of SKF depend on the oil level; c contains them.
/// Domain:   oil bath; speed >= 0, viscosity > 0. M is zero at standstill.
struct Churning {
  static constexpr std::string_view id = "churning";
  static constexpr std::string_view title = "churning of the oil bath";
  static constexpr std::string_view mechanism =
      "Balls stir the oil in the bearing. The resistance of this viscous flow grows more with "
      "viscosity than with speed.";
  static constexpr std::string_view formula =
      "M = c (n/10000 rpm)^0.621 (nu/20 mm2/s)^1.379 (n: speed, nu: viscosity, c: moment at "
      "10000 rpm and 20 mm2/s)";
  static constexpr std::string_view source = "exponents of the second term of the SKF drag moment";
  static constexpr std::array<std::string_view, 3> confused_with{"f0", "viscous-exponent",
                                                                 "cage-friction"};
  static constexpr std::string_view settled_by = "the torque with less oil in the bearing";
  static constexpr std::array parameters{Parameter{.name = "torque_at_10000_rpm_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 20.0,
                                                   .lower = 0.0,
                                                   .upper = 1e5,
                                                   .plausible_lower = 1.0,
                                                   .plausible_upper = 300.0}};
  static constexpr double size_power = 3.0;
  static constexpr std::array needs{Need::speed_levels, Need::viscosity_levels};
  static constexpr std::array supplies{friction::Supply::bath};

  static double unit_moment(const MomentInputs& in) {
    if (!(in.state.speed > 0.0)) return 0.0;
    return std::pow(in.state.speed / (10000.0 * rpm), 0.621) *
           std::pow(in.state.kinematic_viscosity / (20.0 * mm2_per_s), 1.379) * N_mm;
  }
};

}  // namespace raceway::effects
