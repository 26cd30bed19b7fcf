#pragma once

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Preload force that differs from the entered or recorded preload force.
///
///   P -> k P
///
/// P is the entered or recorded preload, and k P the true preload.
/// Source:   definition. Preload classes have a tolerance of about 20 %. A force set by the
///           tightening torque of a nut is less accurate.
/// Domain:   k > 0. The effect is for sets whose preload is given as a force, not as an offset of
///           the ring faces.
struct PreloadCalibration {
  static constexpr std::string_view id = "preload-calibration";
  static constexpr Form form = Form::shaft;
  static constexpr bool for_spindle = false;
  static constexpr std::string_view title = "the preload differs from the entered value";
  static constexpr std::string_view datum = "the preload";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: all preloads of the model and the record have the same "
      "relative error.";
  static constexpr std::string_view formula = "k P in place of the preload P (k: factor)";
  static constexpr std::string_view source = "definition; the usual range is assumed";
  static constexpr std::array<std::string_view, 4> confused_with{"ball-material", "mounting",
                                                                 "interference-fit", "preload_N"};
  static constexpr std::string_view settled_by =
      "the preload, from the axial deflection under a known load";
  static constexpr std::array parameters{Parameter{.name = "factor",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.2,
                                                   .upper = 5.0,
                                                   .plausible_lower = 0.6,
                                                   .plausible_upper = 1.6,
                                                   .neutral = 1.0}};
  static constexpr std::array<Need, 0> needs{};

  static void condition(const ConditionInputs&, std::span<const double> values, Condition& c) {
    c.preload_error += values[0] - 1.0;
  }

  static std::string correction(std::span<const double> values) {
    return fmt::format("the true preload is {:.3g} times the entered preload", values[0]);
  }
};

}  // namespace raceway::effects
