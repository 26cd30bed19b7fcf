#pragma once

#include <optional>
#include <string_view>

#include "record/units.h"

namespace raceway::friction {

/// Lubricant supply of the bearing.
enum class Supply { oil_air, grease, jet, bath };

/// Name in files: "oil-air", "grease", "jet", "bath".
[[nodiscard]] std::string_view name(Supply supply);
/// Name in text: "oil-air", "grease", "an oil jet", "an oil bath".
[[nodiscard]] std::string_view words(Supply supply);
/// Returns the supply with this name in files.
[[nodiscard]] std::optional<Supply> find_supply(std::string_view name);

/// Kinematic viscosity of a lubricant (of a grease: of its base oil) against temperature [m²/s].
///
///   log log Z = A - B log T,   Z = ν + 0.7 + exp(-1.47 - 1.84 ν - 0.51 ν²)
///   ν = (Z - 0.7) - exp(-0.7487 - 3.295 (Z - 0.7) + 0.6119 (Z - 0.7)² - 0.3193 (Z - 0.7)³)
///
/// ν [mm²/s], T [K]; converted here, nowhere else. A and B follow from the values at 40 and 100 °C.
/// The printed inverse is off by up to 2.4e-4; Newton's method on the first line removes this
/// error, so the given values are reproduced.
///
/// Source:   [ASTMD341, eqs. 1 to 3].
/// Domain:   ν at 40 °C from 1 to 100 000 mm²/s, at 100 °C from 0.5 mm²/s to below that at 40 °C; T
///           > 0. Meant for liquid hydrocarbons from -70 to 370 °C and ν above 0.21 mm²/s; outside,
///           ν keeps falling with T, towards 0.1 mm²/s.
/// Accuracy: the equations to rounding. An oil of 100 mm²/s at 40 °C is met within 3 % from 50 to
///           80 °C; near the pour point a real oil is thicker.
class Lubricant {
 public:
  /// Throws std::invalid_argument naming the value that is missing or out of range.
  Lubricant(double viscosity_40C, double viscosity_100C);

  [[nodiscard]] double kinematic_viscosity(double temperature) const;
  /// -d ln ν/dT [1/K], the derivative of the first line; positive in its domain.
  [[nodiscard]] double viscosity_slope(double temperature) const;
  [[nodiscard]] double viscosity_40C() const { return viscosity_40C_; }    ///< [m²/s]
  [[nodiscard]] double viscosity_100C() const { return viscosity_100C_; }  ///< [m²/s]

 private:
  double viscosity_40C_, viscosity_100C_;
  double offset_, slope_;  // ln ln Z = offset - slope ln T
};

}  // namespace raceway::friction
