#pragma once

#include <algorithm>

#include "model/spindle.h"
#include "record/units.h"

namespace raceway::spindle {

/// Shaft, ring or housing as one of the two parts of a press fit.
struct PressedPart {
  double bore = unset;      ///< bore diameter [m]; 0 for a solid part
  double diameter = unset;  ///< outer diameter [m]
  model::SolidMaterial material = {};
  double rise = 0.0;  ///< temperature rise above the mounting temperature [K]
};

/// Pressure, gap and radial growth of a press fit.
struct PressFit {
  double pressure = 0.0;  ///< pressure between the two parts [Pa], >= 0
  /// Diametral interference at speed and temperature [m]. A negative value means a loose seat.
  double effective_interference = unset;
  double gap = 0.0;                    ///< radial gap of a loose seat [m], >= 0
  double outer_radius_growth = unset;  ///< radial growth of the outer surface of the outer part [m]
  double inner_radius_growth = unset;  ///< radial growth of the bore of the inner part [m]
  [[nodiscard]] bool loose() const { return !(pressure > 0.0); }
};

/// Returns the radial growth of the outer radius r2 of a rotating ring with the bore radius r1,
/// without pressure on its surfaces [m].
///
///   u(r2) = ρ ω² r2/(4 E) ((1 - ν) r2² + (3 + ν) r1²);   for u(r1), exchange r1 and r2
///
/// ρ, E and ν are density, elastic modulus and Poisson's ratio of the material `m`, and ω is the
/// speed [rad/s]. The argument `radius` is r2, and `other_radius` is r1.
/// Source:   derived from the plane stress of a rotating disc with a hole.
/// Domain:   r1 >= 0.
[[nodiscard]] inline double growth_by_rotation(const model::SolidMaterial& m, double radius,
                                               double other_radius, double speed) {
  const double nu = m.poissons_ratio;
  return m.density * speed * speed * radius / (4.0 * m.elastic_modulus) *
         ((1.0 - nu) * radius * radius + (3.0 + nu) * other_radius * other_radius);
}

/// Computes pressure, gap and radial growth of a press fit. Both parts rotate at the same speed
/// [rad/s].
///
///   p = (δ/2)/(b (c_i/E_i + c_o/E_o)),   δ = δ0 + 2 (u_i - u_o) + 2 b (α_i T_i - α_o T_o)
///   c_i = (b² + a²)/(b² - a²) - ν_i,   c_o = (c² + b²)/(c² - b²) + ν_o
///
/// a is the bore radius of the inner part, b the seat radius, and c the outer radius of the outer
/// part. u_i and u_o are growth_by_rotation() of the inner and the outer part at the radius b. E, ν
/// and α are elastic modulus, Poisson's ratio and coefficient of linear expansion. T_i and T_o are
/// temperature rises above the mounting temperature. δ0 is the diametral interference as mounted
/// and at standstill; a clearance is negative.
/// Source:   Lamé, plane stress. A solution with radial finite elements agrees to a relative
///           difference of 1e-7.
/// Domain:   each part has a uniform temperature and a constant section along the axis. If the seat
///           is loose, pressure and deformation by pressure are zero.
/// Trap:     for the seat of an outer ring in the housing, use speed 0, because the outer ring does
///           not rotate.
[[nodiscard]] inline PressFit press_fit(const PressedPart& inner, const PressedPart& outer,
                                        double interference, double speed) {
  const model::SolidMaterial &i = inner.material, &o = outer.material;
  const double a = 0.5 * inner.bore, b = 0.5 * inner.diameter, c = 0.5 * outer.diameter;
  const double aa = a * a, bb = b * b, cc = c * c;
  const double inner_strain = i.thermal_expansion * inner.rise;
  const double outer_strain = o.thermal_expansion * outer.rise;
  PressFit fit;
  fit.effective_interference =
      interference +
      2.0 * (growth_by_rotation(i, b, a, speed) - growth_by_rotation(o, b, c, speed)) +
      2.0 * b * (inner_strain - outer_strain);
  const double yield = ((bb + aa) / (bb - aa) - i.poissons_ratio) / i.elastic_modulus +
                       ((cc + bb) / (cc - bb) + o.poissons_ratio) / o.elastic_modulus;
  fit.pressure = std::max(0.5 * fit.effective_interference / (b * yield), 0.0);
  fit.gap = std::max(-0.5 * fit.effective_interference, 0.0);
  fit.outer_radius_growth = fit.pressure * 2.0 * bb * c / (o.elastic_modulus * (cc - bb)) +
                            growth_by_rotation(o, c, b, speed) + c * outer_strain;
  fit.inner_radius_growth = -fit.pressure * 2.0 * bb * a / (i.elastic_modulus * (bb - aa)) +
                            growth_by_rotation(i, a, b, speed) + a * inner_strain;
  return fit;
}

}  // namespace raceway::spindle
