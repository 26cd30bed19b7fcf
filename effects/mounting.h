#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Preload mounting that differs from the entered mounting: a spring instead of a rigid mounting,
/// or the reverse.
///
///   s (F_r - F_0) = h K_r (d (x - e) - (δ_r - δ_r0))      seat of the rear bearing set
///   s = (1 - c) s_entered + c s_other,   h = (1 - c) h_entered + c h_other
///
///   c     parameter: 0 for the entered mounting, 1 for the other mounting
///   s, h  coefficients of flexibility (s) and stiffness (h) of the seat of the rear set [1]
///   F_r   axial force of the rear set; F_0: value at mounting
///   δ_r   axial compression of the rear set; δ_r0: value at mounting
///   K_r   axial stiffness of the rear set at mounting
///   x     position of the shaft
///   e     thermal elongation of the shaft relative to the housing
///   d     -1 in an X arrangement, otherwise 1
///
/// A rigid mounting has s = K_r/K and h = 1, where K is the stiffness of shaft and housing in
/// series. A spring of stiffness k has s = 1 and h = k/K_r. A spring of constant force has s = 1
/// and h = 0. The preload force at mounting is the same for every c.
///
/// If the entered mounting is rigid, c reduces the variation of the preload. The seat then acts
/// like a spring in series: rear set and seat together have the stiffness (1 - c) K_r. c = 1 then
/// means a constant preload force.
///
/// Source:   springs in series, derived.
/// Domain:   0 <= c <= 1, bearing sets at both ends. A value of c between 0 and 1 describes a
///           flexible housing, or a spring whose force depends on its length. c = 1 means that the
///           wrong mounting was entered.
struct OtherMounting {
  static constexpr std::string_view id = "mounting";
  static constexpr Form form = Form::shaft;
  static constexpr bool as_mounted = true;
  static constexpr std::string_view title =
      "spring preload instead of rigid preload, or the reverse";
  static constexpr std::string_view mechanism =
      "With a spring or a flexible housing, the preload varies less than in rigid sets. A change "
      "of the contact angles then moves the shaft by a different amount.";
  static constexpr std::string_view formula =
      "rigid preload: its variation is reduced by the share c, as with a spring in series; "
      "spring preload: the seat of the rear set is interpolated between the spring (c = 0) "
      "and a rigid seat (c = 1)";
  static constexpr std::string_view source = "springs in series, derived";
  static constexpr std::array<std::string_view, 4> confused_with{
      "preload_N", "shaft-contraction", "centrifugal-ring-growth", "thermal-preload"};
  static constexpr std::string_view settled_by =
      "the axial deflection of the shaft under a known load";
  static constexpr std::array parameters{Parameter{.name = "share",
                                                   .unit = "1",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.05,
                                                   .plausible_upper = 1.0}};
  static constexpr std::array needs{Need::opposed_sets, Need::preload_levels};

  static void condition(const ConditionInputs&, std::span<const double> values, Condition& c) {
    c.other_mounting += values[0];
  }
};

}  // namespace raceway::effects
