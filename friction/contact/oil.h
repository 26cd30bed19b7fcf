#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "friction/lubricant.h"
#include "record/units.h"

/// Friction laws for contacts of ball and race: film, rolling resistance of the oil, traction,
/// hysteresis. bearing_friction() sums the friction over a bearing.
namespace raceway::friction::contact {

/// Types of oil, with different properties in oil_defaults(). For a grease, use the type of its
/// base oil.
enum class OilType { mineral, pao, ester };

/// Name of an oil type in files: "mineral", "pao", "ester".
[[nodiscard]] constexpr std::string_view name(OilType type) {
  return type == OilType::mineral ? "mineral" : type == OilType::pao ? "pao" : "ester";
}
[[nodiscard]] constexpr std::optional<OilType> find_oil_type(std::string_view name_of_type) {
  for (const OilType type : {OilType::mineral, OilType::pao, OilType::ester})
    if (name(type) == name_of_type) return type;
  return std::nullopt;
}

/// Default properties of a type of oil.
struct OilDefaults {
  double density_15C;           ///< ρ15, density at 15 °C [kg/m³]
  double conductivity;          ///< k_f, thermal conductivity [W/(m K)]
  double limiting_traction;     ///< largest shear stress of the film divided by pressure [1]
  double pressure_viscosity_s;  ///< s in pressure_viscosity(): α [1/GPa] = s ν^t, ν in mm²/s
  double pressure_viscosity_t;  ///< t in pressure_viscosity(), exponent of ν [1]
};

/// Returns the default properties of a type of oil.
///
/// Source:   textbook values of each type; s and t of the pressure-viscosity coefficient by
///           [Gold2001]. The values were not checked against the publications.
/// Accuracy: 3 % for the density, 15 % for conductivity and pressure-viscosity coefficient, 30 %
///           for the limiting traction. At contact pressures below about 1.2 GPa, the limiting
///           traction changes the torque of a spindle bearing by less than 0.1 %.
[[nodiscard]] constexpr OilDefaults oil_defaults(OilType type) {
  switch (type) {
    case OilType::pao:
      return {830.0, 0.15, 0.045, 7.382, 0.1335};
    case OilType::ester:
      return {930.0, 0.15, 0.04, 6.605, 0.136};
    case OilType::mineral:
      break;
  }
  return {880.0, 0.13, 0.06, 9.904, 0.139};
}

/// Default Eyring stress, above which a film is shear-thinning [Pa]. Published values for bearing
/// oils are 2 to 10 MPa.
inline constexpr double default_eyring_stress = 5.0 * MPa;

/// Decrease of the density of an oil per kelvin, relative to its density at 15 °C [1/K]. Published
/// tables give 6.4e-4 to 7e-4.
inline constexpr double density_slope = 6.5e-4;

/// Density of an oil, ρ = ρ15 (1 - 6.5e-4 (T - 15 °C)) [kg/m³]. Domain: T below 1500 °C, so that ρ
/// is positive.
[[nodiscard]] inline double oil_density(double density_15C, double temperature) {
  return density_15C * (1.0 - density_slope * (temperature - kelvin(15.0)));
}

/// Pressure-viscosity coefficient of a type of oil at its current viscosity [1/Pa].
///
///   α = s ν^t,   α [1/GPa], ν [mm²/s]; the code converts these units
///
/// Source:   [Gold2001], not checked against the paper. Domain: ν > 0.
/// Accuracy: α is accurate to 15 % for oils of one type. This error changes the friction of a
///           bearing by at most 4 %.
[[nodiscard]] inline double pressure_viscosity(OilType type, double kinematic_viscosity) {
  const OilDefaults oil = oil_defaults(type);
  return oil.pressure_viscosity_s *
         std::pow(kinematic_viscosity / mm2_per_s, oil.pressure_viscosity_t) / GPa;
}

/// Properties of an oil at one temperature and ambient pressure.
struct OilState {
  double kinematic_viscosity = unset;  ///< ν [m²/s]
  double density = unset;              ///< ρ [kg/m³]
  double viscosity = unset;            ///< η = ν ρ [Pa s]
  double viscosity_slope = unset;      ///< β = -d ln η/dT [1/K]
  double pressure_viscosity = unset;   ///< α [1/Pa]
  double conductivity = unset;         ///< k_f [W/(m K)]
};

/// Properties of an oil in addition to its viscosities. If a property is NaN, oil_state() uses the
/// default of the oil type.
struct OilData {
  OilType type = OilType::mineral;
  double density_15C = unset;         ///< [kg/m³]
  double conductivity = unset;        ///< [W/(m K)]
  double pressure_viscosity = unset;  ///< α, independent of temperature [1/Pa]
};

/// Returns the properties of an oil at a temperature [K]. Domain: as for Lubricant. With η = ν ρ, β
/// is -d ln ν/dT - d ln ρ/dT.
[[nodiscard]] inline OilState oil_state(const Lubricant& lubricant, const OilData& oil,
                                        double temperature) {
  const OilDefaults usual = oil_defaults(oil.type);
  const auto given = [](double value, double otherwise) {
    return std::isnan(value) ? otherwise : value;
  };
  const double density_15C = given(oil.density_15C, usual.density_15C);
  const double density = oil_density(density_15C, temperature);
  const double nu = lubricant.kinematic_viscosity(temperature);
  return {.kinematic_viscosity = nu,
          .density = density,
          .viscosity = nu * density,
          .viscosity_slope =
              lubricant.viscosity_slope(temperature) + density_slope * density_15C / density,
          .pressure_viscosity = given(oil.pressure_viscosity, pressure_viscosity(oil.type, nu)),
          .conductivity = given(oil.conductivity, usual.conductivity)};
}

}  // namespace raceway::friction::contact
