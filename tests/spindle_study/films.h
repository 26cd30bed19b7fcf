#pragma once

#include <algorithm>
#include <cmath>

#include "tests/spindle_study/bearing_set.h"

// Heat from surface to surface and to the air, one law per function; lengths m, temperatures K.
namespace spindle_study {

struct Air {
  double viscosity = nan;  ///< kinematic [m²/s]
  double conductivity = nan, prandtl = nan;
};

/// Dry air at 1013 hPa: Sutherland's viscosity (1.458e-6, 110.4 K) and conductivity
/// (2.495e-3 T^1.5/(T + 194)), ideal gas, c_p 1006 J/(kg K).
inline Air air_at(double temperature) {
  const double root = temperature * std::sqrt(temperature);
  const double dynamic = 1.458e-6 * root / (temperature + 110.4);
  const double conductivity = 2.495e-3 * root / (temperature + 194.0);
  return {dynamic * 287.05 * temperature / 101325.0, conductivity, dynamic * 1006.0 / conductivity};
}

inline double rayleigh(const Air& air, double length, double rise, double film_temperature) {
  return 9.81 * std::fabs(rise) * length * length * length * air.prandtl /
         (film_temperature * air.viscosity * air.viscosity);
}

/// Horizontal cylinder, mean over its circumference [W/(m² K)].
/// Source: Churchill and Chu 1975.
inline double free_cylinder(double diameter, double rise, const Air& air, double film_temperature) {
  const double ra = rayleigh(air, diameter, rise, film_temperature);
  const double shape = std::pow(1.0 + std::pow(0.559 / air.prandtl, 9.0 / 16.0), 8.0 / 27.0);
  const double nu = 0.6 + 0.387 * std::pow(ra, 1.0 / 6.0) / shape;
  return nu * nu * air.conductivity / diameter;
}

/// Vertical plate [W/(m² K)]. Source: Churchill and Chu 1975.
inline double free_plate(double height, double rise, const Air& air, double film_temperature) {
  const double ra = rayleigh(air, height, rise, film_temperature);
  const double shape = std::pow(1.0 + std::pow(0.492 / air.prandtl, 9.0 / 16.0), 8.0 / 27.0);
  const double nu = 0.825 + 0.387 * std::pow(ra, 1.0 / 6.0) / shape;
  return nu * nu * air.conductivity / height;
}

/// Turning cylinder in still air, 0.133 Re^(2/3) Pr^(1/3) [W/(m² K)]. Source: Becker 1963.
inline double turning_cylinder(double diameter, double speed, const Air& air) {
  const double re = speed * diameter * diameter / (2.0 * air.viscosity);
  return 0.133 * std::pow(re, 2.0 / 3.0) * std::cbrt(air.prandtl) * air.conductivity / diameter;
}

/// Between turning shaft and bore, from surface to surface; Nu on 2 δ [W/(m² K)].
/// Source: Becker and Kaye 1962.
inline double annular_gap(double inner_radius, double outer_radius, double speed, const Air& air) {
  const double gap = outer_radius - inner_radius;
  const double ta = speed * speed * 0.5 * (inner_radius + outer_radius) * gap * gap * gap /
                    (air.viscosity * air.viscosity);
  const double nu = ta < 1700.0 ? 2.0
                    : ta < 1e4  ? 0.128 * std::pow(ta, 0.367)
                                : 0.409 * std::pow(ta, 0.241);
  return nu * air.conductivity / (2.0 * gap);
}

/// [W/(m² K)].
inline double radiation(double emissivity, double a, double b) {
  return emissivity * 5.670374e-8 * (a * a + b * b) * (a + b);
}

/// Water in a channel: mean over its length, laminar below Re 2300, Gnielinski above 4000, linear
/// between [W/(m² K)]. Source: VDI-Waermeatlas G1.
inline double channel(double flow, double width, double depth, double length) {
  constexpr double viscosity = 1e-6, conductivity = 0.6, prandtl = 7.0;
  const double d = 2.0 * width * depth / (width + depth);
  const double re = flow / (width * depth) * d / viscosity;
  const auto laminar = [&](double r) {
    const double entry = 1.615 * std::cbrt(r * prandtl * d / length) - 0.7;
    return std::cbrt(3.66 * 3.66 * 3.66 + 0.7 * 0.7 * 0.7 + entry * entry * entry);
  };
  const auto turbulent = [&](double r) {
    const double f = std::pow(1.8 * std::log10(r) - 1.5, -2.0) / 8.0;
    return f * r * prandtl / (1.0 + 12.7 * std::sqrt(f) * (std::pow(prandtl, 2.0 / 3.0) - 1.0)) *
           (1.0 + std::pow(d / length, 2.0 / 3.0));
  };
  double nu = 0.0;
  if (re < 2300.0) {
    nu = laminar(re);
  } else if (re > 4000.0) {
    nu = turbulent(re);
  } else {
    const double share = (re - 2300.0) / 1700.0;
    nu = (1.0 - share) * laminar(2300.0) + share * turbulent(4000.0);
  }
  return nu * conductivity / d;
}

/// Plane stress of a ring from `bore` to `outer` radius.
struct Hoop {
  double bore, outer, modulus, poisson, density, expansion;
};

/// Radial growth at the radius by rotation alone [m].
inline double growth_at_speed(const Hoop& h, double radius, double speed) {
  const double a2 = h.bore * h.bore, b2 = h.outer * h.outer, r2 = radius * radius;
  const double v = h.poisson;
  return h.density * speed * speed * radius / h.modulus * (3.0 + v) * (1.0 - v) / 8.0 *
         (a2 + b2 + (1.0 + v) / (1.0 - v) * a2 * b2 / r2 - (1.0 + v) / (3.0 + v) * r2);
}

struct Fit {
  double pressure;  ///< [Pa], 0 when loose
  double gap;       ///< radial [m], 0 when tight
};

/// Inner body pressed into the outer one at inner.outer = outer.bore; `interference` diametral,
/// cold and still [m]; rises of both bodies [K]. Source: Lame.
inline Fit press(const Hoop& inner, const Hoop& outer, double interference, double inner_speed,
                 double outer_speed, double inner_rise, double outer_rise) {
  const double b = outer.bore;
  const double overlap = 0.5 * interference + growth_at_speed(inner, b, inner_speed) -
                         growth_at_speed(outer, b, outer_speed) +
                         b * (inner.expansion * inner_rise - outer.expansion * outer_rise);
  if (overlap <= 0.0) return {0.0, -overlap};
  const double a2 = inner.bore * inner.bore, b2 = b * b, c2 = outer.outer * outer.outer;
  const double give = ((b2 + a2) / (b2 - a2) - inner.poisson) / inner.modulus +
                      ((c2 + b2) / (c2 - b2) + outer.poisson) / outer.modulus;
  return {overlap / (b * give), 0.0};
}

/// Two rough faces: 0.46 (Ra/m)(1/l1 + 1/l2)(p/H)^-0.93, beside it the gas in the gaps
/// [W/(m² K)].
inline double rough_contact(const Fit& fit, double roughness, double slope, double hardness,
                            double conductivity1, double conductivity2) {
  const double gas = 0.027 / (3.0 * roughness + fit.gap);
  if (!(fit.pressure > 0.0)) return gas;
  return gas + std::pow(fit.pressure / hardness, 0.93) /
                   (0.46 * roughness / slope * (1.0 / conductivity1 + 1.0 / conductivity2));
}

/// Friction moment of one bearing under an axial load: Palmgren with F_b = 0.9 F_a cot α0 and
/// f1 = z (F_b/C0)^y [N m]; viscosity mm²/s, revolutions in a minute.
inline double palmgren(double f0, double z, double y, double viscosity, double revolutions,
                       double force, const BearingData& b) {
  const double stirred = viscosity * revolutions;
  const double d = b.pitch_diameter * 1e3;
  const double viscous =
      f0 * d * d * d * (stirred >= 2000.0 ? 1e-7 * std::pow(stirred, 2.0 / 3.0) : 160e-7);
  const double load = 0.9 * std::max(force, 0.0) / std::tan(b.contact_angle);
  const double pressed = z * std::pow(load / b.static_rating, y) * load * d;
  return (viscous + pressed) * 1e-3;
}

/// Oil by Walther through its viscosities at 40 and 100 degrees [mm²/s].
struct Oil {
  double at_40 = nan, at_100 = nan;
  [[nodiscard]] double viscosity(double kelvin) const {
    const auto w = [](double v) { return std::log10(std::log10(v + 0.7)); };
    const double x0 = std::log10(313.15), x1 = std::log10(373.15);
    const double m = (w(at_40) - w(at_100)) / (x1 - x0);
    return std::pow(10.0, std::pow(10.0, w(at_40) + m * (x0 - std::log10(kelvin)))) - 0.7;
  }
};

}  // namespace spindle_study
