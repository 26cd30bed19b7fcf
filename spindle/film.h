#pragma once

#include <algorithm>
#include <cmath>

#include "model/spindle.h"
#include "record/units.h"

/// Computes heat transfer between solids and flowing fluids. Most functions contain one correlation
/// and return a heat transfer coefficient h [W/(m² K)]. Nu is the Nusselt number, Re the Reynolds
/// number, and Pr the Prandtl number. The results are finite and not negative, also for equal
/// temperatures of solid and fluid.
namespace raceway::spindle {

/// Thermal properties and viscosity of a fluid at one temperature.
struct FluidProperties {
  double kinematic_viscosity = unset;  ///< [m²/s]
  double conductivity = unset;         ///< [W/(m K)]
  double prandtl = unset;              ///< [1]
  double density = unset;              ///< [kg/m³]
  double heat_capacity = unset;        ///< [J/(kg K)]
  [[nodiscard]] bool operator==(const FluidProperties&) const = default;
};

/// Returns the properties of dry air at 1 bar and the temperature T [K].
///
///   μ = 1.458e-6 T^1.5/(T + 110.4),   λ = 2.64638e-3 T^1.5/(T + 245.4 10^(-12/T))
///
/// Source:   Sutherland's formulas with the constants of the US Standard Atmosphere 1976. Air is
///           treated as an ideal gas with the heat capacity c = 1006 J/(kg K).
/// Domain:   T from 200 to 600 K. Outside this range, the function uses the nearer limit instead of
///           T.
/// Accuracy: 1 % for viscosity and conductivity, 0.5 % for the heat capacity c below 400 K.
[[nodiscard]] inline FluidProperties air_properties(double temperature) {
  constexpr double pressure = 1e5, gas_constant = 287.05, heat_capacity = 1006.0;
  const double T = std::clamp(temperature, 200.0, 600.0);
  const double root = T * std::sqrt(T);
  const double viscosity = 1.458e-6 * root / (T + 110.4);
  const double conductivity = 2.64638e-3 * root / (T + 245.4 * std::pow(10.0, -12.0 / T));
  const double density = pressure / (gas_constant * T);
  return {.kinematic_viscosity = viscosity / density,
          .conductivity = conductivity,
          .prandtl = viscosity * heat_capacity / conductivity,
          .density = density,
          .heat_capacity = heat_capacity};
}

/// Returns the properties of a fluid at a temperature [K]. The file film.cpp gives formulas and
/// sources.
[[nodiscard]] FluidProperties fluid_properties(model::Fluid fluid, double temperature);

/// Acceleration of gravity g in the correlations [m/s²].
inline constexpr double gravity = 9.81;
/// Stefan-Boltzmann constant, CODATA 2018 [W/(m² K⁴)].
inline constexpr double stefan_boltzmann = 5.670374419e-8;

/// Returns the Rayleigh number of a gas, Ra = g ΔT l³ Pr/(T_film ν²) [1]. ΔT is the temperature
/// difference between surface and gas, l the characteristic length, T_film the mean of surface and
/// gas temperature [K], and ν the kinematic viscosity.
[[nodiscard]] inline double rayleigh(double length, double difference, double film_temperature,
                                     const FluidProperties& gas) {
  const double nu = gas.kinematic_viscosity;
  return gravity * std::abs(difference) * length * length * length * gas.prandtl /
         (film_temperature * nu * nu);
}

/// Returns the Nusselt number of free convection by Churchill and Chu [1]:
///
///   Nu = (c + 0.387 Ra^(1/6)/(1 + (d/Pr)^(9/16))^(8/27))²
///
/// The constants c = `still` and d = `prandtl_constant` depend on the shape of the body, see
/// free_cylinder() and free_plate().
[[nodiscard]] inline double churchill_chu(double still, double prandtl_constant, double rayleigh,
                                          double prandtl) {
  const double fluid = std::pow(1.0 + std::pow(prandtl_constant / prandtl, 9.0 / 16.0), 8.0 / 27.0);
  const double root = still + 0.387 * std::pow(rayleigh, 1.0 / 6.0) / fluid;
  return root * root;
}

/// Returns the free convection coefficient of a horizontal cylinder [W/(m² K)].
///
///   Nu = (0.60 + 0.387 Ra^(1/6)/(1 + (0.559/Pr)^(9/16))^(8/27))²
///
/// The characteristic length of Nu and Ra is the diameter D.
/// Source:   Churchill and Chu (Int J Heat Mass Transfer 18, 1975, p. 1049).
/// Domain:   Ra from 1e-5 to 1e12. Without a temperature difference, the result is 0.36 λ/D with
///           the conductivity λ of the gas.
/// Accuracy: about 10 %. The influence of neighbouring machine parts is larger than this error.
[[nodiscard]] inline double free_cylinder(double diameter, double difference,
                                          double film_temperature, const FluidProperties& gas) {
  const double ra = rayleigh(diameter, difference, film_temperature, gas);
  return churchill_chu(0.60, 0.559, ra, gas.prandtl) * gas.conductivity / diameter;
}

/// Returns the free convection coefficient of a vertical wall, for example an end face [W/(m² K)].
///
///   Nu = (0.825 + 0.387 Ra^(1/6)/(1 + (0.492/Pr)^(9/16))^(8/27))²
///
/// The characteristic length of Nu and Ra is the height.
/// Source:   Churchill and Chu (Int J Heat Mass Transfer 18, 1975, p. 1323).
/// Domain:   Ra up to 1e12.
[[nodiscard]] inline double free_plate(double height, double difference, double film_temperature,
                                       const FluidProperties& gas) {
  const double ra = rayleigh(height, difference, film_temperature, gas);
  return churchill_chu(0.825, 0.492, ra, gas.prandtl) * gas.conductivity / height;
}

/// Returns the heat transfer coefficient of a shaft that turns in still air [W/(m² K)].
///
///   Re = ω D²/(2 ν);  becker            Nu = 0.133 Re^(2/3) Pr^(1/3)
///                     kendoush          Nu = 0.6366 (Re Pr)^(1/2)
///                     anderson_saunders Nu = 0.1 Re^(2/3)
///
/// The characteristic length of Nu is the diameter D. ω is the speed, ν the kinematic viscosity.
/// Source:   Becker 1963; Kendoush 1996; Anderson and Saunders 1953.
/// Domain:   speed >= 0. The result is zero at standstill; turning_shaft() includes free
///           convection.
/// Accuracy: the three laws differ by a factor of up to 1.7 for a shaft of 80 mm diameter at 10 000
///           rpm.
[[nodiscard]] inline double rotating_shaft(model::RotatingConvection law, double speed,
                                           double diameter, const FluidProperties& gas) {
  const double re = speed * diameter * diameter / (2.0 * gas.kinematic_viscosity);
  double nusselt = 0.0;
  switch (law) {
    case model::RotatingConvection::becker:
      nusselt = 0.133 * std::cbrt(re * re * gas.prandtl);
      break;
    case model::RotatingConvection::kendoush:
      nusselt = 0.6366 * std::sqrt(re * gas.prandtl);
      break;
    case model::RotatingConvection::anderson_saunders:
      nusselt = 0.1 * std::cbrt(re * re);
      break;
  }
  return nusselt * gas.conductivity / diameter;
}

/// Returns the larger heat transfer coefficient of rotating_shaft() and free_cylinder() [W/(m² K)].
[[nodiscard]] inline double turning_shaft(model::RotatingConvection law, double speed,
                                          double diameter, double difference,
                                          double film_temperature, const FluidProperties& gas) {
  return std::max(rotating_shaft(law, speed, diameter, gas),
                  free_cylinder(diameter, difference, film_temperature, gas));
}

/// Returns the Taylor number of the gap δ between a rotating and a fixed cylinder, Ta = ω² r_m
/// δ³/ν² [1]. ω is the speed, r_m the arithmetic mean of both radii, and ν the kinematic viscosity.
[[nodiscard]] inline double taylor_number(double inner_radius, double outer_radius, double speed,
                                          const FluidProperties& gas) {
  const double gap = outer_radius - inner_radius;
  const double root = speed / gas.kinematic_viscosity;
  return root * root * 0.5 * (inner_radius + outer_radius) * gap * gap * gap;
}

/// Returns the thermal conductance h of the gap δ between a rotating and a fixed cylinder [W/(m²
/// K)]. The conductance is the heat flow between both surfaces per kelvin and per area at the mean
/// radius.
///
///   h = Nu λ/(2 δ);   Nu = 2,   0.128 Ta^0.367 if Ta > 1700,   0.409 Ta^0.241 if Ta > 1e4
///
/// λ is the conductivity of the gas, and Ta is taylor_number().
/// Source:   Becker and Kaye (J Heat Transfer 84, 1962, p. 97). The characteristic length of Nu is
///           2 δ, and its temperature difference is the difference between both surfaces.
/// Domain:   no axial flow. The published law jumps by 2 % at Ta = 1700 and by 0.1 % at Ta = 1e4.
///           This function has no jumps, because the change between two formulas is at the Taylor
///           number for which both formulas give the same result (1790 and 1.01e4).
/// Accuracy: about 15 % for smooth surfaces.
[[nodiscard]] inline double annular_gap(double inner_radius, double outer_radius, double speed,
                                        const FluidProperties& gas) {
  const double ta = taylor_number(inner_radius, outer_radius, speed, gas);
  const double nusselt =
      std::max(2.0, std::min(0.128 * std::pow(ta, 0.367), 0.409 * std::pow(ta, 0.241)));
  return nusselt * gas.conductivity / (2.0 * (outer_radius - inner_radius));
}

/// Returns the mean Nusselt number of the flow through a channel of length l [1]. Nu and Re are
/// based on the hydraulic diameter d, and ξ is the friction factor.
///
///   Re <= 2300   (3.66³ + 0.7³ + (1.615 (Re Pr d/l)^(1/3) - 0.7)³)^(1/3)
///   Re >= 4000   (ξ/8) Re Pr/(1 + 12.7 (ξ/8)^(1/2) (Pr^(2/3) - 1)) (1 + (d/l)^(2/3)),
///                ξ = (1.8 lg Re - 1.5)^-2;      linear in Re from 2300 to 4000
///
/// Source:   VDI-Wärmeatlas 2002, G1 (uniform wall temperature; Gnielinski). The formula was not
///           checked against the printed edition. Gnielinski's older formula, which contains Re -
///           1000, gives a Nusselt number that is 23 % lower at Re = 4000, 8 % lower at 1e4 and
///           nearly equal above 1e5.
/// Domain:   Re up to 1e6, straight and smooth channel. A helical channel has a larger Nusselt
///           number.
[[nodiscard]] inline double channel_nusselt(double reynolds, double prandtl,
                                            double diameter_by_length) {
  const auto laminar = [&](double re) {
    const double entry = 1.615 * std::cbrt(re * prandtl * diameter_by_length) - 0.7;
    return std::cbrt(3.66 * 3.66 * 3.66 + 0.7 * 0.7 * 0.7 + entry * entry * entry);
  };
  const auto turbulent = [&](double re) {
    const double root = 1.8 * std::log10(re) - 1.5;
    const double friction = 1.0 / (8.0 * root * root);
    return friction * re * prandtl /
           (1.0 + 12.7 * std::sqrt(friction) * (std::cbrt(prandtl * prandtl) - 1.0)) *
           (1.0 + std::cbrt(diameter_by_length * diameter_by_length));
  };
  constexpr double lowest = 2300.0, highest = 4000.0;
  if (reynolds <= lowest) return laminar(reynolds);
  if (reynolds >= highest) return turbulent(reynolds);
  const double share = (reynolds - lowest) / (highest - lowest);
  return (1.0 - share) * laminar(lowest) + share * turbulent(highest);
}

/// Returns Darcy's friction factor of a channel with rectangular section [1]. a is the ratio of the
/// shorter to the longer side.
///
///   Re <= 2300   96 (1 - 1.3553 a + 1.9467 a² - 1.7012 a³ + 0.9564 a⁴ - 0.2537 a⁵)/Re
///   Re >= 4000   (1.8 lg Re - 1.5)^-2;      linear in Re from 2300 to 4000
///
/// Source:   Shah and London 1978 (laminar); Konakov 1946 (turbulent, the formula of ξ in
///           channel_nusselt()).
/// Domain:   Re > 0, 0 < a <= 1, straight and smooth channel.
/// Accuracy: the factor agrees with tables within 0.1 % in laminar flow, and with Prandtl's law of
///           smooth pipes within 1.5 % up to Re = 1e6. The secondary flow in a helical channel
///           increases the factor by some tens of percent in turbulent flow. In laminar flow, the
///           increase is several times larger than in turbulent flow.
[[nodiscard]] inline double channel_friction(double reynolds, double aspect) {
  const auto laminar = [&](double re) {
    const double a = aspect;
    return 96.0 * (1.0 - a * (1.3553 - a * (1.9467 - a * (1.7012 - a * (0.9564 - a * 0.2537))))) /
           re;
  };
  const auto turbulent = [](double re) {
    const double root = 1.8 * std::log10(re) - 1.5;
    return 1.0 / (root * root);
  };
  constexpr double lowest = 2300.0, highest = 4000.0;
  if (reynolds <= lowest) return laminar(reynolds);
  if (reynolds >= highest) return turbulent(reynolds);
  const double share = (reynolds - lowest) / (highest - lowest);
  return (1.0 - share) * laminar(lowest) + share * turbulent(highest);
}

/// Helical channel with a rectangular section of width w and depth d, calculated as a straight
/// channel.
struct Channel {
  double section = unset;             ///< area w d of the section [m²]
  double hydraulic_diameter = unset;  ///< 2 w d/(w + d) [m]
  double length = unset;              ///< length of the helix [m]
  /// Returns Re = v d_h/ν for a flow [m³/s], with mean velocity v, hydraulic diameter d_h and
  /// kinematic viscosity ν.
  [[nodiscard]] double reynolds(double flow, const FluidProperties& fluid) const {
    return flow / section * hydraulic_diameter / fluid.kinematic_viscosity;
  }
  /// Returns the heat transfer coefficient at the channel walls for a flow in m³/s [W/(m² K)].
  [[nodiscard]] double film(double flow, const FluidProperties& fluid) const {
    return channel_nusselt(reynolds(flow, fluid), fluid.prandtl, hydraulic_diameter / length) *
           fluid.conductivity / hydraulic_diameter;
  }
};

/// Returns the channel of a coolant circuit. The length of one turn of the helix is
/// sqrt(circumference² + pitch²).
[[nodiscard]] inline Channel channel_of(const model::Coolant& c) {
  const double turns = std::abs(c.end - c.start) / c.pitch;
  return {.section = c.channel_width * c.channel_depth,
          .hydraulic_diameter =
              2.0 * c.channel_width * c.channel_depth / (c.channel_width + c.channel_depth),
          .length = turns * std::hypot(pi * c.diameter, c.pitch)};
}

/// Returns the heat transfer coefficient at the channel walls for a mean coolant temperature in K
/// [W/(m² K)]. If the coolant is off or has no flow, the result is `stagnant`, the coefficient that
/// the model gives for standing fluid. A flowing coolant never has a smaller coefficient than
/// standing fluid.
[[nodiscard]] inline double coolant_film(const model::Coolant& c, double temperature, bool on) {
  if (!on || !(c.flow > 0.0)) return c.stagnant;
  return std::max(c.stagnant, channel_of(c).film(c.flow, fluid_properties(c.fluid, temperature)));
}

/// Returns 2 V ρ c for a coolant flow V with the density ρ and the heat capacity c [W/K]. Multiply
/// the result by the mean coolant temperature minus the inlet temperature to get the heat that the
/// coolant removes. The mean temperature lies halfway between inlet and outlet temperature. The
/// result is zero if the coolant is off.
[[nodiscard]] inline double coolant_conductance(const model::Coolant& c, double temperature,
                                                bool on) {
  if (!on) return 0.0;
  const FluidProperties fluid = fluid_properties(c.fluid, temperature);
  return 2.0 * c.flow * fluid.density * fluid.heat_capacity;
}

inline constexpr double bar = 1e5;  ///< [Pa]

/// Velocity, heat transfer and pressure drops of a coolant in its channel.
struct ChannelFlow {
  double velocity = unset;       ///< mean velocity [m/s]
  double reynolds = unset;       ///< [1]
  double film = unset;           ///< heat transfer coefficient [W/(m² K)]
  double pressure_drop = unset;  ///< pressure drop of the channel [Pa]
  /// Pressure drop of an orifice behind the channel [Pa]; 0 without an orifice.
  double throttle_drop = 0.0;
};

/// Computes velocity, heat transfer and pressure drops at a mean temperature of the coolant [K].
///
///   channel  Δp = ξ (l/d_h) ρ v²/2;   orifice  Δp = ρ/2 (V/(0.61 A))²
///
/// ξ is channel_friction(), l and d_h are length and hydraulic diameter of the channel, ρ is the
/// density, v the mean velocity, V the flow, and A the area of the orifice.
/// Source:   Darcy and Weisbach. The factor 0.61 is within 2 % of ISO 5167 for a sharp-edged
///           orifice that is much smaller than the pipe.
/// Domain:   flow > 0. Bends, fittings and hoses are neglected.
[[nodiscard]] inline ChannelFlow channel_flow(const model::Coolant& c, double temperature) {
  constexpr double sharp_orifice = 0.61;
  const Channel channel = channel_of(c);
  const FluidProperties fluid = fluid_properties(c.fluid, temperature);
  ChannelFlow flow{.velocity = c.flow / channel.section,
                   .reynolds = channel.reynolds(c.flow, fluid),
                   .film = coolant_film(c, temperature, true)};
  const double aspect =
      std::min(c.channel_width, c.channel_depth) / std::max(c.channel_width, c.channel_depth);
  const double dynamic = 0.5 * fluid.density * flow.velocity * flow.velocity;
  flow.pressure_drop = channel_friction(flow.reynolds, aspect) * channel.length /
                       channel.hydraulic_diameter * dynamic;
  if (!std::isnan(c.throttle_diameter)) {
    const double opening = 0.25 * pi * c.throttle_diameter * c.throttle_diameter;
    const double jet = c.flow / (sharp_orifice * opening);
    flow.throttle_drop = 0.5 * fluid.density * jet * jet;
  }
  return flow;
}

/// Returns the heat transfer coefficient of radiation to large surroundings [W/(m² K)]. The
/// temperature T of the surface and T0 of the surroundings are in K.
///
///   h = ε σ (T² + T0²)(T + T0)
///
/// ε is the emissivity, and σ the Stefan-Boltzmann constant.
/// Source:   [Brecher2021, eqs. 1, 2].
[[nodiscard]] inline double radiation(double emissivity, double temperature, double surroundings) {
  return emissivity * stefan_boltzmann * (temperature * temperature + surroundings * surroundings) *
         (temperature + surroundings);
}

/// Returns the heat transfer coefficient of radiation between two long grey coaxial cylinders, per
/// area of the inner cylinder [W/(m² K)].
///
///   1/ε = 1/ε_i + (r_i/r_o)(1/ε_o - 1)
///
/// ε is the effective emissivity in the formula of radiation(). The indices i and o denote the
/// inner and the outer cylinder, and r is a radius.
/// Domain:   emissivities above 0.
[[nodiscard]] inline double radiation_of_gap(double inner_radius, double outer_radius,
                                             double inner_emissivity, double outer_emissivity,
                                             double inner_temperature, double outer_temperature) {
  const double emissivity =
      1.0 / (1.0 / inner_emissivity + inner_radius / outer_radius * (1.0 / outer_emissivity - 1.0));
  return radiation(emissivity, inner_temperature, outer_temperature);
}

}  // namespace raceway::spindle
