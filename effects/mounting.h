#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Mounting that differs from the entered mounting of the sets: spring instead of rigid, or rigid
/// instead of spring.
///
///   s (F_r - F_0) = h K_r (d (x - e) - (δ_r - δ_r0))      seat of the rear set
///   s = (1 - c) s_entered + c s_other,   h = (1 - c) h_entered + c h_other
///
/// F_r is the axial force of the rear set, δ_r its axial compression, x the position of the shaft,
/// and e the thermal elongation of the shaft relative to the housing. The index 0 means: as
/// mounted. d is -1 in an X arrangement, otherwise 1. K_r is the stiffness of the rear set as
/// mounted. c interpolates between the entered mounting (c = 0) and the other mounting (c = 1). The
/// seat is described by its softness s and its hardness h. The seat of a rigid set has s = K_r/K
/// and h = 1, where K is the stiffness of shaft and housing in series. The seat of a spring of
/// stiffness k has s = 1 and h = k/K_r. A spring of constant force has s = 1 and h = 0. In
/// bearing::Arrangement, the compliance 1/K of shaft and housing is called c.
///
/// In a rigid set, c is the share by which a spring in series reduces the variation of the preload,
/// because rear set and seat together have the stiffness (1 - c) K_r. c = 0 is the set as entered,
/// and c = 1 is a constant preload force. The mounted preload force always remains the value of the
/// model.
///
/// Source:   springs in series, derived.
/// Domain:   0 <= c <= 1, sets at both ends. A value of c between 0 and 1 describes a flexible
///           housing, or a spring whose force depends on its length. c = 1 means that the wrong
///           mounting was entered.
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
      "rigid sets: a spring in series reduces the variation of the preload by the share c; spring "
      "sets: the mounting changes by the share c towards rigid";
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
