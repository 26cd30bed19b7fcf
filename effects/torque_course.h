#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "effects/effect.h"

// Faults of a torque sensor that depend on the sequence of the measurements.
namespace raceway::effects {

/// Zero drift from the start of each day [N m].
///
///   M_read = M + c t/1 h
///
/// M_read is the reading, M the true torque, t the time, and c the drift per hour.
/// Source:   definition. Possible causes are an amplifier that warms up, and a sensor that is set
///           to zero each morning.
/// Domain:   the record must contain the time of every row. t starts from zero each day, that is,
///           after each pause of more than three hours. If the record has no such pause, t starts
///           from zero with each load sweep (model/course.h).
struct TorqueCreep {
  static constexpr std::string_view id = "torque-creep";
  static constexpr std::string_view title = "zero of the torque sensor creeps over each day";
  static constexpr std::string_view datum = "the zero of the torque sensor over the day";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the zero of the sensor moves from the start of each day. "
      "If the loads are always measured in one order, the drift looks like an effect of load.";
  static constexpr std::string_view formula =
      "M_read = M + c (t - t_start)/1 h (M: true torque, c: drift per hour, t: time, "
      "t_start: start of the day, or of the load sweep if the record has no long pause)";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 3> confused_with{"load-exponent", "load-offset",
                                                                 "torque-time-drift"};
  static constexpr std::string_view settled_by =
      "the torque of the standing shaft at the start and the end of each day";
  static constexpr std::array parameters{Parameter{.name = "torque_per_hour_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 0.0,
                                                   .lower = -1e5,
                                                   .upper = 1e5,
                                                   .plausible_lower = -20.0,
                                                   .plausible_upper = 20.0}};
  static constexpr double size_power = 3.0;
  static constexpr std::array needs{Need::time};
  static constexpr const record::Channel& channel = record::friction_torque;

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return values[0] * N_mm * in.record.since_start / 3600.0;
  }

  static std::string correction(std::span<const double> values) {
    return fmt::format("the zero moves by {:+.3g} N mm per hour", values[0]);
  }
};

/// Hysteresis of the reading, which depends on the direction of the speed change [N m].
///
///   M_read = M + c/2  speed reached from below,   M - c/2  from above
///
/// M_read is the reading, M the true torque, and c the difference between the readings for rising
/// and falling speed.
/// Source:   definition. Possible causes are a sensor with hysteresis, and a support that sticks.
/// Domain:   the record must contain the time of every row. The first speed of a run is assumed to
///           be reached from below, and so is the first speed after a change of the axial load
///           (Record::direction).
struct SpeedHysteresis {
  static constexpr std::string_view id = "speed-hysteresis";
  static constexpr std::string_view title = "readings differ between rising and falling speed";
  static constexpr std::string_view datum = "the hysteresis of the torque sensor";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: at one speed, the reading for rising speed differs from "
      "the reading for falling speed.";
  static constexpr std::string_view formula =
      "M_read = M + c/2 for rising speed, M - c/2 for falling speed (M: true torque, c: "
      "difference of the two readings)";
  static constexpr std::string_view source = "definition";
  static constexpr std::array<std::string_view, 2> confused_with{"torque-time-drift",
                                                                 "grease-churning"};
  static constexpr std::string_view settled_by =
      "each speed once from below and once from above, at one temperature";
  static constexpr std::array parameters{Parameter{.name = "torque_Nmm",
                                                   .unit = "N mm",
                                                   .initial = 0.0,
                                                   .lower = -1e5,
                                                   .upper = 1e5,
                                                   .plausible_lower = -40.0,
                                                   .plausible_upper = 40.0}};
  static constexpr double size_power = 3.0;
  static constexpr std::array needs{Need::time, Need::rising_and_falling};
  static constexpr const record::Channel& channel = record::friction_torque;

  static double reading(const ReadingInputs& in, std::span<const double> values) {
    return 0.5 * values[0] * N_mm * in.record.direction;
  }

  static std::string correction(std::span<const double> values) {
    return fmt::format("the sensor reads {:.3g} N mm {} at rising speed than at falling speed",
                       std::abs(values[0]), values[0] > 0.0 ? "more" : "less");
  }
};

}  // namespace raceway::effects
