#pragma once

#include <array>
#include <span>
#include <string_view>

#include "friction/spin.h"
#include "friction/state.h"

namespace raceway::effects {

/// Friction moment of the balls that spin about the normal of a contact [N m].
///
///   M = μ Σ (3/8) Q a E(k) ω_s/ω      under outer control Z M_s ω_s/ω at the inner race
///
/// Source:   [CaseStudy, eq. 23; Harris2006, vol. 2, ch. 5]; μ of 0.04 to 0.08 is usual.
/// Domain:   converged equilibrium, else NaN; see unit_spin_friction() for standstill.
/// Accuracy: that of unit_spin_moment(). Derivatives are those by μ: the balance is solved in
/// double.
struct SpinFriction {
  static constexpr std::string_view id = "spin-friction";
  static constexpr std::string_view title = "spinning friction of the balls";
  static constexpr std::string_view mechanism =
      "A ball that rolls on two races at different contact angles must turn about the normal of "
      "one "
      "contact. The contact ellipse slides and takes power, more so the further speed drives the "
      "two angles apart.";
  static constexpr std::string_view formula =
      "M = sum of (3/8) mu Q a E(k) w_s/w over the contacts";
  static constexpr std::string_view source =
      "[CaseStudy, eq. 23]; Harris and Kotzalas, Rolling Bearing Analysis, vol. 2, ch. 5";
  static constexpr std::array<std::string_view, 3> confused_with{"z", "gyroscopic-slip",
                                                                 "thermal-preload"};
  static constexpr std::array parameters{friction::Parameter{
      .name = "friction_coefficient", .unit = "1", .initial = 0.06, .lower = 0.0, .upper = 0.5}};
  static constexpr bool needs_equilibrium = true;

  template <typename T>
  static T moment(const friction::BearingState<T>& s, std::span<const T> values) {
    if (s.equilibrium == nullptr) return T(unset);
    const friction::ContactPair spin =
        friction::unit_spin_friction(*s.bearing, *s.equilibrium, s.race_control);
    return values[0] * (spin.inner + spin.outer);
  }
};

}  // namespace raceway::effects
