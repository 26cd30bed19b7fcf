#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Common part of ThermalRingGrowth (a bearing on a rig) and ShaftThermalRingGrowth (bearing sets
/// of a shaft). If the inner ring is warmer than the outer ring, the inner raceway grows relative
/// to the outer raceway. The free radial expansion is
///
///   λ (T_i - T_o) d_m/2
///
/// T_i and T_o are the temperatures of inner and outer ring, λ is the coefficient of thermal
/// expansion of the rings, and d_m the pitch diameter. For steel and d_m = 90 mm, the expansion is
/// 0.5 um per kelvin.
struct GrowthByRingTemperatures {
  static constexpr std::string_view id = "thermal-ring-growth";
  static constexpr bool follows_heat = true;

  /// Returns T_i - T_o [K]; NaN if one of these temperatures was not recorded.
  static double difference(const Record& record) {
    return record.inner_ring_temperature - record.outer_ring_temperature;
  }
};

/// Radial growth of the inner raceway relative to the outer raceway from measured ring
/// temperatures, for a bearing on a rig [m].
///
///   u = c λ (T_i - T_o) d_m/2
///
/// The growth changes the free contact angle α0: cos α0 becomes cos α0 + u/A, where A is the
/// distance between the groove centres. If α0 = 0, the radial clearance decreases by 2 u.
/// Source:   free thermal expansion, derived. The factor c = 1 means unconstrained rings.
/// Domain:   both ring temperatures are measured. The balls are assumed to have the temperature of
///           the outer ring.
struct ThermalRingGrowth : GrowthByRingTemperatures {
  static constexpr Form form = Form::rig;
  static constexpr std::string_view title = "rings with different temperatures";
  static constexpr std::string_view mechanism =
      "If the inner ring is warmer than the outer ring, the clearance and the contact angle fall, "
      "and the ball loads rise for the same axial load.";
  static constexpr std::string_view formula =
      "u = c lambda (T_i - T_o) d_m/2 (u: growth of the raceway radius, c: share, lambda: "
      "coefficient of thermal expansion of the rings, T_i and T_o: temperatures of inner "
      "and outer ring, d_m: pitch diameter)";
  static constexpr std::string_view source = "free thermal expansion, derived";
  static constexpr std::array<std::string_view, 3> confused_with{
      "thermal-preload", "centrifugal-ring-growth", "interference-fit"};
  static constexpr std::array parameters{Parameter{.name = "share",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.0,
                                                   .upper = 2.0,
                                                   .plausible_lower = 0.3,
                                                   .plausible_upper = 1.5}};
  static constexpr std::array needs{Need::ring_temperatures, Need::loads, Need::ball_load_law};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.radial_growth += values[0] * in.bearing.rings().thermal_expansion * difference(in.record) *
                       0.5 * in.bearing.geometry().pitch_diameter;
  }
};

/// Radial growth of the inner raceway relative to the outer raceway, in addition to the free
/// thermal expansion, in the bearing sets of a shaft [m].
///
///   g = c (T_i - T_o)
///
/// The equilibrium of the sets already includes the free expansion of rings and balls
/// (bearing::thermal_shift), so c = 0 means unconstrained rings. c > 0 means that the housing
/// constrains the outer ring, or that sensors outside the rings show a smaller temperature
/// difference than the difference between the raceways. c < 0 means that the shaft constrains the
/// inner ring. c = -λ d_m/2 cancels the whole radial expansion.
/// Source:   derived.
/// Domain:   both ring temperatures are known.
struct ShaftThermalRingGrowth : GrowthByRingTemperatures {
  static constexpr Form form = Form::shaft;
  // In a spindle, the computed temperatures already cause this growth.
  static constexpr bool for_spindle = false;
  static constexpr std::string_view title = "rings that do not expand freely with temperature";
  static constexpr std::string_view mechanism =
      "The free expansion of rings at their measured temperatures is part of every prediction. A "
      "stiff or cool housing, the shaft, or sensors away from the raceways make the real growth "
      "larger or smaller.";
  static constexpr std::string_view formula =
      "in addition to the free expansion, the radius of the inner raceway grows by c (T_i - "
      "T_o) (c: growth per kelvin, T_i and T_o: temperatures of inner and outer ring)";
  static constexpr std::string_view source =
      "derived; c is the deviation from free thermal expansion";
  static constexpr std::array<std::string_view, 3> confused_with{
      "thermal-preload", "centrifugal-ring-growth", "displacement-temperature-drift"};
  static constexpr std::array parameters{Parameter{.name = "growth_per_kelvin_um_K",
                                                   .unit = "um/K",
                                                   .initial = 0.1,
                                                   .lower = -3.0,
                                                   .upper = 3.0,
                                                   .plausible_lower = -0.5,
                                                   .plausible_upper = 0.5}};
  static constexpr std::array needs{Need::ring_temperatures};

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.radial_growth += values[0] * um * difference(in.record);
  }
};

}  // namespace raceway::effects
