#pragma once

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Gain error of a load cell, or of a lever in front of it.
///
///   F_a,read = s F_a
///
/// F_a,read is the recorded axial load, F_a the true load, and s the gain.
/// Source:   definition. Load cells are accurate to 0.1 to 1 % of full scale. A wrong lever arm, a
///           wrong sensitivity or friction in the loading device causes errors up to 20 %.
/// Domain:   s > 0. Palmgren's load moment is a factor z times a power of the load. Without radial
///           load, a fitted z therefore compensates the load error. A diagnosis can find the load
///           error if the record has a radial load, or if the model has effects that depend on the
///           ball loads.
struct LoadCalibration {
  static constexpr std::string_view id = "load-calibration";
  static constexpr Form form = Form::rig;
  static constexpr std::string_view title = "gain error of the load cell";
  static constexpr std::string_view datum = "the calibration of the axial load";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: all axial loads of the record have the same relative "
      "error.";
  static constexpr std::string_view formula =
      "F_a_read = s F_a (F_a_read: recorded axial load, F_a: true axial load, s: "
      "share_read)";
  static constexpr std::string_view source = "definition; the usual range is assumed";
  static constexpr std::array<std::string_view, 3> confused_with{"z", "load-offset",
                                                                 "load-exponent"};
  static constexpr std::string_view settled_by =
      "the reading of the load cell under a known weight";
  static constexpr std::array parameters{Parameter{.name = "share_read",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.3,
                                                   .upper = 3.0,
                                                   .plausible_lower = 0.8,
                                                   .plausible_upper = 1.25,
                                                   .neutral = 1.0}};
  static constexpr std::array needs{Need::load_levels};
  static constexpr std::string_view not_for_rollers =
      "the effect acts on the axial load, which cylindrical rollers do not carry";

  static void condition(const ConditionInputs& in, std::span<const double> values, Condition& c) {
    c.extra_axial_load += in.point.axial_load * (1.0 / values[0] - 1.0);
  }

  static std::string correction(std::span<const double> values) {
    return fmt::format("the true axial loads are {:.3g} times the recorded loads", 1.0 / values[0]);
  }
};

}  // namespace raceway::effects
