#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Description of an effect that adds a heat source to a spindle: texts, and the parameter `size`
/// for the heat flow.
template <std::size_t confused>
struct SpindleHeatCard {
  double SpindleCondition::*heat;  ///< member that receives the heat flow
  std::string_view id, title, mechanism, source;
  std::array<std::string_view, confused> confused_with;
  Parameter size;
};

/// Heat flow into a spindle from a source that the model does not contain [W].
///
///   q = W n/10 000 rpm
///
/// q is the heat flow at the speed n, and W the heat flow at 10 000 rpm.
/// Source:   assumption of a constant loss moment. In fact, losses in a motor rotor and in air grow
///           with a higher power of the speed.
/// Domain:   speed >= 0; q is zero at standstill. The heat flow is added to the heat sources of the
///           model.
template <const auto& card>
struct SpindleHeat {
  static constexpr Form form = Form::spindle;
  static constexpr std::string_view id = card.id;
  static constexpr std::string_view title = card.title;
  static constexpr std::string_view mechanism = card.mechanism;
  static constexpr std::string_view formula =
      "q = W (n/10000 rpm) (q: heat flow, W: heat flow at 10000 rpm, n: speed)";
  static constexpr std::string_view source = card.source;
  static constexpr auto confused_with = card.confused_with;
  static constexpr std::array parameters{card.size};
  static constexpr std::array needs{Need::time, Need::speed_levels};
  static constexpr bool follows_heat = true;

  static void spindle(std::span<const double> values, SpindleCondition& c) {
    c.*card.heat += values[0];
  }
};

inline constexpr SpindleHeatCard<4> motor_heat{
    .heat = &SpindleCondition::motor_heat,
    .id = "motor-heat",
    .title = "heat of a motor between the sets",
    .mechanism =
        "Losses of rotor and stator heat shaft and housing between the sets, independently of the "
        "bearings.",
    .source =
        "assumption: the loss moment does not depend on speed; iron losses rise with a higher "
        "power of speed",
    .confused_with = {"drive-heat", "coolant", "lubricant-drag", "convection-factor"},
    .size = {.name = "heat_at_10000_rpm_W",
             .unit = "W",
             .initial = 100.0,
             .lower = 0.0,
             .upper = 20000.0,
             .plausible_lower = 20.0,
             .plausible_upper = 3000.0}};

inline constexpr SpindleHeatCard<4> drive_heat{
    .heat = &SpindleCondition::drive_heat,
    .id = "drive-heat",
    .title = "heat of a belt or coupling at the rear shaft end",
    .mechanism =
        "A belt that slips and bends, or a coupling, heats the shaft behind the last bearing: "
        "first the shaft end becomes hot, then the rear bearing.",
    .source = "assumption: the loss moment does not depend on speed",
    .confused_with = {"motor-heat", "bearing-conductance", "lubricant-drag", "f0"},
    .size = {.name = "heat_at_10000_rpm_W",
             .unit = "W",
             .initial = 50.0,
             .lower = 0.0,
             .upper = 5000.0,
             .plausible_lower = 10.0,
             .plausible_upper = 500.0}};

inline constexpr SpindleHeatCard<4> seal_heat{
    .heat = &SpindleCondition::seal_heat,
    .id = "seal-heat",
    .title = "heat of a seal at the nose",
    .mechanism =
        "A seal lip or a touching labyrinth heats the shaft in front of the first bearing, "
        "independently of load and preload.",
    .source =
        "assumption: the seal moment does not depend on speed, as in the SKF general "
        "catalogue (2006)",
    .confused_with = {"drive-heat", "lubricant-drag", "seal-friction", "f0"},
    .size = {.name = "heat_at_10000_rpm_W",
             .unit = "W",
             .initial = 20.0,
             .lower = 0.0,
             .upper = 2000.0,
             .plausible_lower = 5.0,
             .plausible_upper = 200.0}};

inline constexpr SpindleHeatCard<4> front_bearing_heat{
    .heat = &SpindleCondition::front_bearing_heat,
    .id = "front-bearing-heat",
    .title = "heat at the front bearings that is not in their friction law",
    .mechanism =
        "Seals, grease or a load that is not in the model heat both rings of the front set. These "
        "rings become hot first; the rear bearing runs as predicted.",
    .source = "assumption: the added moment does not depend on speed",
    .confused_with = {"seal-heat", "f0", "lubricant-drag", "preload_N"},
    .size = {.name = "heat_at_10000_rpm_W",
             .unit = "W",
             .initial = 50.0,
             .lower = 0.0,
             .upper = 5000.0,
             .plausible_lower = 10.0,
             .plausible_upper = 1000.0}};

/// Heat source in the roller bearing behind the rear set. If the spindle has no roller bearing at
/// this place, the heat source is in the rear set.
inline constexpr SpindleHeatCard<4> rear_bearing_heat{
    .heat = &SpindleCondition::rear_bearing_heat,
    .id = "rear-bearing-heat",
    .title = "heat at the rear bearing that is not in its friction law",
    .mechanism =
        "A belt force that tilts the rear bearing, a seal of this bearing, or too much grease "
        "heats both rings: the rings become hot first, the shaft end later.",
    .source = "assumption: the added moment does not depend on speed",
    .confused_with = {"drive-heat", "f0", "lubricant-drag", "bearing-conductance"},
    .size = {.name = "heat_at_10000_rpm_W",
             .unit = "W",
             .initial = 50.0,
             .lower = 0.0,
             .upper = 5000.0,
             .plausible_lower = 10.0,
             .plausible_upper = 1000.0}};

}  // namespace raceway::effects
