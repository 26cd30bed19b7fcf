#pragma once

#include <limits>
#include <numbers>

namespace raceway {

/// NaN, the value of a number that is not given or not known.
inline constexpr double unset = std::numeric_limits<double>::quiet_NaN();

// Factors to SI: `12.7 * mm` is a length in m, and `length / mm` is the number of millimetres.
inline constexpr double pi = std::numbers::pi;
inline constexpr double mm = 1e-3;              ///< [m]
inline constexpr double um = 1e-6;              ///< [m]
inline constexpr double rpm = pi / 30.0;        ///< [rad/s]
inline constexpr double degree = pi / 180.0;    ///< [rad]
inline constexpr double mrad = 1e-3;            ///< [rad]
inline constexpr double GPa = 1e9;              ///< [Pa]
inline constexpr double MPa = 1e6;              ///< [Pa]
inline constexpr double mm2_per_s = 1e-6;       ///< [m²/s]
inline constexpr double N_mm = 1e-3;            ///< [N m]
inline constexpr double N_per_um = 1e6;         ///< [N/m]
inline constexpr double per_million_K = 1e-6;   ///< [1/K]
inline constexpr double celsius_zero = 273.15;  ///< 0 °C expressed in kelvin [K]

/// Converts a temperature from [°C] to [K].
inline constexpr double kelvin(double celsius) { return celsius + celsius_zero; }
/// Converts a temperature from [K] to [°C].
inline constexpr double celsius(double kelvin) { return kelvin - celsius_zero; }

}  // namespace raceway
