#include "spindle/film.h"

#include "friction/lubricant.h"

namespace raceway::spindle {
namespace {

/// Liquid water at 1 bar.
///
///   μ [mPa s]   (t + 246)/((0.05594 t + 5.2842) t + 137.37)
///   ρ [kg/m³]   (999.83952 + 16.945176 t - 7.9870401e-3 t² - 46.170461e-6 t³
///                + 105.56302e-9 t⁴ - 280.54253e-12 t⁵)/(1 + 16.87985e-3 t)
///   λ [W/(m K)] 0.6065 (-1.48445 + 4.12292 τ - 1.63866 τ²),   τ = T/298.15 K
///   c           polynomial in t
///
/// t in °C. Source: Laliberté 2007; Kell 1975; Ramires et al. 1995; c: fitted to the values of
/// IAPWS-95 every 10 K. At 20 °C: ν 1.004 mm²/s, λ 0.598, Pr 7.0, ρ 998.2, c 4184.
/// Domain:   0 to 100 °C, held there outside: neither ice nor steam.
/// Accuracy: viscosity 0.5 %, conductivity 1 %, density 0.01 %, c 0.03 %.
FluidProperties water_properties(double temperature) {
  const double t = std::clamp(celsius(temperature), 0.0, 100.0);
  const double viscosity = 1e-3 * (t + 246.0) / ((0.05594 * t + 5.2842) * t + 137.37);
  const double density =
      (999.83952 +
       t * (16.945176 +
            t * (-7.9870401e-3 + t * (-46.170461e-6 + t * (105.56302e-9 - t * 280.54253e-12))))) /
      (1.0 + 16.87985e-3 * t);
  const double tau = kelvin(t) / 298.15;
  const double conductivity = 0.6065 * (-1.48445 + tau * (4.12292 - 1.63866 * tau));
  const double x = t / 100.0;
  const double heat_capacity =
      4218.885 - x * (289.949 - x * (711.237 - x * (700.103 - 276.020 * x)));
  return {.kinematic_viscosity = viscosity / density,
          .conductivity = conductivity,
          .prandtl = viscosity * heat_capacity / conductivity,
          .density = density,
          .heat_capacity = heat_capacity};
}

/// Thin mineral oil as spindle coolers hold it, ISO VG 10.
///
///   ν by ASTM D341 from 10 mm²/s at 40 °C and 2.6 mm²/s at 100 °C;   ρ = 850 - 0.65 (t - 15)
///   λ = 0.134 - 7e-5 t,   c = 1800 + 3.7 t
///
/// t in °C. Source: usual values of mineral oils, an assumption: no card is asked for.
/// Domain:   -10 to 120 °C, held there outside.
/// Accuracy: oils of one viscosity class differ by 10 % in ν, 5 % in λ and c.
FluidProperties oil_properties(double temperature) {
  static const friction::Lubricant oil(10.0 * mm2_per_s, 2.6 * mm2_per_s);
  const double t = std::clamp(celsius(temperature), -10.0, 120.0);
  const double density = 850.0 - 0.65 * (t - 15.0);
  const double conductivity = 0.134 - 7e-5 * t, heat_capacity = 1800.0 + 3.7 * t;
  const double viscosity = oil.kinematic_viscosity(kelvin(t));
  return {.kinematic_viscosity = viscosity,
          .conductivity = conductivity,
          .prandtl = viscosity * density * heat_capacity / conductivity,
          .density = density,
          .heat_capacity = heat_capacity};
}

}  // namespace

FluidProperties fluid_properties(model::Fluid fluid, double temperature) {
  return fluid == model::Fluid::water ? water_properties(temperature) : oil_properties(temperature);
}

}  // namespace raceway::spindle
