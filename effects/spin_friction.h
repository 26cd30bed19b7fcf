#pragma once

#include <array>
#include <string_view>

#include "effects/effect.h"
#include "friction/spin.h"

namespace raceway::effects {

/// Friction moment of ball spin about the contact normal [N m].
///
///   M = μ Σ (3/8) Q a E(k) ω_s/ω      over all contacts
///
/// μ is the friction coefficient, Q the load of a contact, a the semi-major axis of its ellipse,
/// and E(k) a complete elliptic integral (see unit_spin_moment()). ω_s is the spin speed in the
/// contact and ω the shaft speed. Under outer race control, only the contacts at the inner race
/// spin.
/// Source:   [CaseStudy, eq. 23; Harris2006, vol. 2, ch. 5]; μ of 0.04 to 0.08 is usual.
/// Domain:   converged equilibrium of the balls; otherwise M is NaN. For standstill see
///           unit_spin_friction().
/// Accuracy: see unit_spin_moment().
struct SpinFriction {
  static constexpr std::string_view id = "spin-friction";
  static constexpr std::string_view title = "spinning friction of the balls";
  static constexpr std::string_view mechanism =
      "A ball that rolls on two races at different contact angles spins about the normal of "
      "one contact, so the surfaces slide in the contact ellipse. The power of this sliding "
      "rises with speed, because speed increases the difference of the two angles.";
  static constexpr std::string_view formula =
      "M = sum of (3/8) mu Q a E(k) w_s/w over the contacts (mu: friction coefficient, Q: "
      "contact load, a: half length of the contact ellipse, E(k): elliptic integral, w_s: "
      "spin speed, w: shaft speed)";
  static constexpr std::string_view within_contacts =
      "mu_boundary under [friction], limiting_traction under [lubricant]";
  static constexpr std::string_view not_for_rollers =
      "cylindrical rollers do not spin in their contacts";
  static constexpr std::string_view source =
      "[CaseStudy, eq. 23]; Harris and Kotzalas, Rolling Bearing Analysis, vol. 2, ch. 5";
  static constexpr std::array<std::string_view, 3> confused_with{"z", "gyroscopic-slip",
                                                                 "thermal-preload"};
  static constexpr std::string_view settled_by =
      "the same points with a bearing of different contact angle";
  static constexpr std::array parameters{Parameter{.name = "friction_coefficient",
                                                   .unit = "1",
                                                   .initial = 0.06,
                                                   .lower = 0.0,
                                                   .upper = 0.5,
                                                   .plausible_lower = 0.02,
                                                   .plausible_upper = 0.12}};
  static constexpr std::array needs{Need::loads, Need::load_levels};
  static constexpr bool needs_equilibrium = true;
  static constexpr bool spin = true;

  static double unit_moment(const MomentInputs& in) {
    const friction::BearingState<double>& s = in.state;
    if (s.equilibrium == nullptr) return unset;
    const friction::ContactPair spin =
        friction::unit_spin_friction(*s.bearing, *s.equilibrium, s.race_control);
    return spin.inner + spin.outer;
  }
};

}  // namespace raceway::effects
