#pragma once

#include <array>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Wrong oil grade: the viscosity differs by the same factor at every temperature.
///
///   ν40 -> k ν40,   ν100 -> k ν100
///
/// ν40 and ν100 are the kinematic viscosities at 40 °C and 100 °C, and k is the factor.
/// Source:   definition. Adjacent ISO grades (ISO 3448) differ by a factor of 1.5, and an oil may
///           deviate by 10 % from the midpoint viscosity of its grade.
/// Domain:   every viscosity. Palmgren's viscous moment is proportional to f0 ν^(2/3), so a fitted
///           f0 compensates this error. f0 does not compensate the error at low speed with thin oil
///           (ν n below 2000 mm²/s rpm; ν: viscosity, n: speed). f0 also does not compensate the
///           error in other friction terms that depend on viscosity.
struct LubricantViscosity {
  static constexpr std::string_view id = "lubricant-viscosity";
  static constexpr std::string_view title = "the oil grade differs from the entered grade";
  static constexpr std::string_view datum = "the oil card";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the viscosity of the oil in the bearing differs from the "
      "entered viscosity by the same factor at all temperatures.";
  static constexpr std::string_view formula =
      "nu40 -> k nu40, nu100 -> k nu100 (nu40 and nu100: viscosity at 40 and 100 C, k: "
      "factor)";
  static constexpr std::string_view source = "definition; grades of ISO 3448";
  static constexpr std::array<std::string_view, 2> confused_with{"f0", "viscosity-slope"};
  static constexpr std::string_view settled_by =
      "the viscosity of the oil in use at 40 and 100 C, or the same points with a second oil";
  static constexpr std::array parameters{Parameter{.name = "factor_at_40_C",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.2,
                                                   .upper = 5.0,
                                                   .plausible_lower = 0.45,
                                                   .plausible_upper = 2.2,
                                                   .neutral = 1.0}};
  static constexpr std::array<Need, 0> needs{};
  static constexpr bool of_viscous_moment = true;
  static constexpr bool for_spindle = false;  // in a spindle, f0 compensates this error

  static void entry(Entry& entry, std::span<const double> values) {
    entry.viscosity_40C *= values[0];
    entry.viscosity_100C *= values[0];
  }
};

/// Wrong viscosity index: the viscosity falls with temperature at another rate than entered.
///
///   ν100 -> k ν100,   ν40 unchanged
///
/// Source:   definition. The ν100 of two oils of the same grade can differ by about 20 %. For
///           example, an oil with ν40 = 32 mm²/s has ν100 = 5.4 mm²/s if the viscosity index is 95,
///           and 6.1 mm²/s if the index is 150.
/// Domain:   records with more than one temperature; k ν100 must be below ν40.
struct ViscositySlope {
  static constexpr std::string_view id = "viscosity-slope";
  static constexpr std::string_view title =
      "the viscosity falls faster or more slowly with temperature than entered";
  static constexpr std::string_view datum = "the oil card";
  static constexpr std::string_view mechanism =
      "Wrong data, not missing physics: the viscosity of the oil in the bearing falls faster or "
      "more slowly with temperature than in the model.";
  static constexpr std::string_view formula =
      "nu100 -> k nu100 (nu100: viscosity at 100 C, k: factor); the viscosity at 40 C does "
      "not change";
  static constexpr std::string_view source = "definition; viscosity index of ISO 2909";
  static constexpr std::array<std::string_view, 4> confused_with{
      "temperature-offset", "temperature-gain", "churning", "cage-friction"};
  static constexpr std::string_view settled_by =
      "the viscosity of the oil in use at 40 and 100 C, or the same points with a second oil";
  static constexpr std::array parameters{Parameter{.name = "factor_at_100_C",
                                                   .unit = "1",
                                                   .initial = 1.0,
                                                   .lower = 0.3,
                                                   .upper = 3.0,
                                                   .plausible_lower = 0.7,
                                                   .plausible_upper = 1.4,
                                                   .neutral = 1.0}};
  static constexpr std::array needs{Need::viscosity_levels};
  static constexpr bool of_viscous_moment = true;
  static constexpr bool of_each_record = true;

  static void entry(Entry& entry, std::span<const double> values) {
    entry.viscosity_100C *= values[0];
  }
};

}  // namespace raceway::effects
