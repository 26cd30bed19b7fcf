#pragma once

#include <optional>
#include <string_view>

#include "record/units.h"

namespace raceway::friction {

/// Lubricant supply of the bearing.
enum class Supply { oil_air, grease, jet, bath };

/// Name of a supply in files: "oil-air", "grease", "jet", "bath".
[[nodiscard]] std::string_view name(Supply supply);
/// Words for a supply in messages: "oil-air", "grease", "an oil jet", "an oil bath".
[[nodiscard]] std::string_view words(Supply supply);
/// Returns the supply with this name in files; nullopt for other names.
[[nodiscard]] std::optional<Supply> find_supply(std::string_view name);

/// Kinematic viscosity of a lubricant as a function of temperature [m²/s]. For a grease, use the
/// viscosities of the base oil.
///
///   log log Z = A - B log T,   Z = ν + 0.7 + exp(-1.47 - 1.84 ν - 0.51 ν²)
///   ν = (Z - 0.7) - exp(-0.7487 - 3.295 (Z - 0.7) + 0.6119 (Z - 0.7)² - 0.3193 (Z - 0.7)³)
///
/// ν is in mm²/s and T in K; the class converts these units. A and B follow from the viscosities at
/// 40 and 100 °C. The second line is the published approximate inverse of Z(ν), with a relative
/// error of up to 2.8e-4. The class corrects this error, so the computed viscosities at 40 and 100
/// °C equal the given viscosities.
///
/// Source:   [ASTMD341, eqs. 1 to 3].
/// Domain:   ν at 40 °C from 1 to 100 000 mm²/s; ν at 100 °C at least 0.5 mm²/s and below ν at 40
///           °C; T > 0. The source covers liquid hydrocarbons from -70 to 370 °C and ν above 0.21
///           mm²/s. At higher temperatures, the computed ν approaches 0.1 mm²/s.
/// Accuracy: the code agrees with the equations to rounding error. From 50 to 80 °C, the computed
///           viscosities agree within 3 % with [KRW2006] for an oil of 100 mm²/s at 40 °C. Near the
///           pour point, the viscosity of a real oil is higher than computed.
class Lubricant {
 public:
  /// Kinematic viscosities at 40 and 100 °C [m²/s]. Throws std::invalid_argument if a viscosity is
  /// NaN or outside the domain above; the message names this viscosity.
  Lubricant(double viscosity_40C, double viscosity_100C);

  [[nodiscard]] double kinematic_viscosity(double temperature) const;
  /// Returns -d ln ν/dT [1/K] from the first line of the formula; positive in the domain.
  [[nodiscard]] double viscosity_slope(double temperature) const;
  [[nodiscard]] double viscosity_40C() const { return viscosity_40C_; }    ///< [m²/s]
  [[nodiscard]] double viscosity_100C() const { return viscosity_100C_; }  ///< [m²/s]

 private:
  double viscosity_40C_, viscosity_100C_;
  double offset_, slope_;  // ln ln Z = offset - slope ln T
};

}  // namespace raceway::friction
