#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Texts and size parameter of an effect that corrects an entered thermal conductance of a spindle.
template <std::size_t confused>
struct SpindleFactorCard {
  double SpindleCondition::*factor;  ///< member that the effect multiplies by k
  std::string_view id, title, mechanism, formula;
  std::array<std::string_view, confused> confused_with;
  Parameter size;
};

/// Factor k on a thermal conductance G of a spindle [1].
///
///   G -> k G
///
/// Source:   definition. Published formulas for convection and thermal contacts are accurate to a
///           factor of 1.2 to 2.
/// Domain:   k >= 0.02, so that no part of the spindle is thermally isolated.
template <const auto& card>
struct SpindleFactor {
  static constexpr Form form = Form::spindle;
  static constexpr std::string_view id = card.id;
  static constexpr std::string_view title = card.title;
  static constexpr std::string_view mechanism = card.mechanism;
  static constexpr std::string_view formula = card.formula;
  static constexpr std::string_view source =
      "definition; formulas for convection and thermal contacts are accurate to a factor of 1.2 to "
      "2";
  static constexpr auto confused_with = card.confused_with;
  static constexpr std::array parameters{card.size};
  static constexpr std::array needs{Need::time};
  static constexpr bool follows_heat = true;

  static void spindle(std::span<const double> values, SpindleCondition& c) {
    c.*card.factor *= values[0];
  }
};

/// A low seat conductance makes the outer rings warmer, which reduces the preload. Temperature
/// sensors in the housing hardly show that the rings are warmer.
inline constexpr SpindleFactorCard<4> seat_conductance{
    .factor = &SpindleCondition::outer_seat_factor,
    .id = "seat-conductance",
    .title = "the thermal conductance of the outer seats differs from the value for their fit",
    .mechanism =
        "A gap, a cover or a wrong fit keeps the heat in the outer rings: the rings become hot and "
        "the preload falls, while the housing hardly changes. Without a sensor on a ring, only the "
        "displacement shows this effect.",
    .formula = "G_seat -> k G_seat (G_seat: conductance of each outer seat, k: factor)",
    .confused_with = {"outer_conductance_W_m2K", "bearing-conductance", "preload-growth",
                      "preload_N"},
    .size = {.name = "factor",
             .unit = "1",
             .initial = 1.0,
             .lower = 0.02,
             .upper = 20.0,
             .plausible_lower = 0.05,
             .plausible_upper = 3.0,
             .neutral = 1.0}};

/// Rotating parts have their own convection, which this effect does not change.
inline constexpr SpindleFactorCard<4> convection_factor{
    .factor = &SpindleCondition::convection_factor,
    .id = "convection-factor",
    .title = "more or less free convection of housing and end faces",
    .mechanism =
        "Draught, a cover or a box around the spindle changes the heat flow to the room, and with "
        "it the long time constant and the steady temperature. The change is clearest while the "
        "spindle cools at standstill.",
    .formula = "h -> k h (h: heat transfer coefficient of housing and end faces, k: factor)",
    .confused_with = {"convection_factor", "flange-conductance", "coolant",
                      "structure-temperature"},
    .size = {.name = "factor",
             .unit = "1",
             .initial = 1.0,
             .lower = 0.02,
             .upper = 20.0,
             .plausible_lower = 0.3,
             .plausible_upper = 4.0,
             .neutral = 1.0}};

/// Rolling balls with lubricant conduct several times more heat than dry contacts. The exact ratio
/// is unknown.
inline constexpr SpindleFactorCard<4> bearing_conductance{
    .factor = &SpindleCondition::bearing_conductance_factor,
    .id = "bearing-conductance",
    .title = "the thermal conductance of balls and lubricant differs from the entered value",
    .mechanism =
        "The heat of the inner rings leaves through balls, oil film and lubricant. With a lower "
        "conductance, shaft and inner rings become hot, and preload and displacement rise; sensors "
        "in the housing hardly show this change.",
    .formula = "G -> k G (G: conductance from inner to outer ring, k: factor)",
    .confused_with = {"lubricant_conductance_W_K", "seat-conductance", "preload-growth",
                      "drive-heat"},
    .size = {.name = "factor",
             .unit = "1",
             .initial = 1.0,
             .lower = 0.02,
             .upper = 50.0,
             .plausible_lower = 0.2,
             .plausible_upper = 5.0,
             .neutral = 1.0}};

inline constexpr SpindleFactorCard<4> flange_conductance{
    .factor = &SpindleCondition::flange_conductance_factor,
    .id = "flange-conductance",
    .title = "the thermal conductance of the flange differs from the entered value",
    .mechanism =
        "More or less heat flows through the flange into the machine: the steady temperature "
        "changes, but not the time constant. Without a sensor at the flange, the effect looks like "
        "a change of convection.",
    .formula = "G_flange -> k G_flange (G_flange: conductance of the flange, k: factor)",
    .confused_with = {"flange_conductance_W_K", "convection-factor", "structure-temperature",
                      "coolant"},
    .size = {.name = "factor",
             .unit = "1",
             .initial = 1.0,
             .lower = 0.02,
             .upper = 50.0,
             .plausible_lower = 0.1,
             .plausible_upper = 10.0,
             .neutral = 1.0}};

}  // namespace raceway::effects
