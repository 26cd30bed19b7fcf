#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Offset of a temperature sensor, or difference between the sensor and the film temperature.
///
///   T_read = T + c
///
/// T_read is the recorded temperature, T the film temperature, and c the offset.
/// Source:   definition. Type K thermocouples are accurate to 1.5 K. Sensor and instrument together
///           are accurate to 3 to 5 K.
/// Domain:   every temperature.
struct TemperatureOffset {
  static constexpr std::string_view id = "temperature-offset";
  static constexpr std::string_view title = "the temperature sensor reads too high or too low";
  static constexpr std::string_view datum = "the temperature sensor";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the recorded temperature has the same error in every row, "
      "so the viscosity is wrong.";
  static constexpr std::string_view formula =
      "T_read = T + c (T_read: recorded temperature, T: film temperature, c: offset)";
  static constexpr std::string_view source = "definition; IEC 60584 for thermocouples";
  static constexpr std::array<std::string_view, 3> confused_with{"f0", "viscosity-slope",
                                                                 "temperature-gain"};
  static constexpr std::string_view settled_by =
      "the temperature of the stationary rig with a second sensor, at two room temperatures";
  static constexpr std::array parameters{Parameter{.name = "offset_K",
                                                   .unit = "K",
                                                   .initial = 0.0,
                                                   .lower = -40.0,
                                                   .upper = 40.0,
                                                   .plausible_lower = -10.0,
                                                   .plausible_upper = 10.0}};
  static constexpr std::array needs{Need::viscosity_levels};
  static constexpr bool for_spindle = false;

  static void entry(Entry& entry, std::span<const double> values) {
    entry.temperature -= values[0];
  }
};

/// Temperature sensor far from the film. The sensor measures only a share of the temperature rise
/// of the film above the room temperature.
///
///   T_read = T_room + s (T - T_room)
///
/// T_read is the recorded temperature, T the film temperature, and s the measured share.
/// Source:   steady heat conduction from the film past the sensor to the room; s is a ratio of
///           thermal resistances.
/// Domain:   s > 0. T_room is the entered room temperature of the rig. If it is not entered, T_room
///           is the temperature of the coldest row of the record.
struct TemperatureGain {
  static constexpr std::string_view id = "temperature-gain";
  static constexpr std::string_view title =
      "the temperature sensor shows a wrong share of the temperature rise";
  static constexpr std::string_view datum = "the place of the temperature sensor";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the sensor is not at the oil film and shows a share "
      "of the temperature rise of the film above the room. With a share below 1, the film "
      "is warmer than the recorded temperature, and the error is largest at high "
      "temperature.";
  static constexpr std::string_view formula =
      "T_read = T_room + s (T - T_room) (T_read: recorded temperature, T: film temperature, "
      "T_room: room temperature, s: measured share)";
  static constexpr std::string_view source =
      "steady heat conduction from the film past the sensor to the room; the usual range is "
      "assumed";
  static constexpr std::array<std::string_view, 4> confused_with{
      "viscosity-slope", "temperature-offset", "film-self-heating", "viscous-exponent"};
  static constexpr std::string_view settled_by =
      "the temperature with a second sensor nearer to the film, for example at the outer ring";
  static constexpr std::array parameters{Parameter{.name = "share_seen",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.15,
                                                   .upper = 3.0,
                                                   .plausible_lower = 0.3,
                                                   .plausible_upper = 1.05,
                                                   .neutral = 1.0}};
  static constexpr std::array needs{Need::viscosity_levels};
  static constexpr bool uses_room = true;
  static constexpr bool for_spindle = false;

  static void entry(Entry& entry, std::span<const double> values) {
    entry.temperature = entry.room + (entry.temperature - entry.room) / values[0];
  }
};

}  // namespace raceway::effects
