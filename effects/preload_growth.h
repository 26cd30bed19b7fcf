#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Friction that grows with the preload of the warm bearing sets.
///
///   P = (1 - s) P(cold) + s P(warm)
///
/// P is the friction power of a bearing. P(warm) is calculated with the bearing forces of the warm
/// sets, and P(cold) with the bearing forces of the cold sets. s is the share of P(warm).
/// Source:   feedback of heat, expansion and preload (Bossmanns and Tu 1999). The interpolation
///           with s is our own.
/// Domain:   0 <= s <= 1, for a model with preload_feedback = false. With s = 1, the friction
///           depends only on the forces of the warm sets.
struct PreloadGrowth {
  static constexpr Form form = Form::spindle;
  static constexpr std::string_view id = "preload-growth";
  static constexpr std::string_view title = "friction that grows with the preload of the warm sets";
  static constexpr std::string_view mechanism =
      "If the inner rings are warmer than the outer rings, the preload rises. The friction "
      "power then rises too, and makes the front bearings still hotter.";
  static constexpr std::string_view formula =
      "friction power P = (1 - s) P(cold sets) + s P(warm sets) (s: share)";
  static constexpr std::string_view source =
      "feedback of heat, expansion and preload [BossmannsTu1999]; the interpolation with s "
      "is derived";
  static constexpr std::array<std::string_view, 4> confused_with{
      "bearing-conductance", "seat-conductance", "z", "lubricant-drag"};
  static constexpr std::array parameters{Parameter{.name = "share",
                                                   .unit = "1",
                                                   .initial = 0.5,
                                                   .lower = 0.0,
                                                   .upper = 1.0,
                                                   .plausible_lower = 0.05,
                                                   .plausible_upper = 1.0}};
  static constexpr std::array needs{Need::time, Need::cold_friction};
  static constexpr bool follows_heat = true;

  static void spindle(std::span<const double> values, SpindleCondition& c) {
    c.other_preload_feedback += values[0];
  }
};

}  // namespace raceway::effects
