#pragma once

#include <algorithm>

#include "model/spindle.h"
#include "record/units.h"

namespace raceway::spindle {

/// One of two round parts that fit into each other.
struct PressedPart {
  double bore = unset;      ///< diameter [m]; 0 for a solid one, of the inner part only
  double diameter = unset;  ///< outer [m]
  model::SolidMaterial material = {};
  double rise = 0.0;  ///< of its temperature over the mounting temperature [K]
};

/// A seat as it is.
struct PressFit {
  double pressure = 0.0;                  ///< [Pa], >= 0
  double effective_interference = unset;  ///< diametral, at speed and temperature; < 0 is loose [m]
  double gap = 0.0;                       ///< radial, of a loose seat [m], >= 0
  double outer_radius_growth = unset;     ///< of the outer surface of the outer part [m]
  double inner_radius_growth = unset;     ///< of the bore of the inner part [m]
  [[nodiscard]] bool loose() const { return !(pressure > 0.0); }
};

/// Growth by rotation of the outer or the inner surface of a ring, free of stress at both [m].
///
///   u(r2) = ρ ω² r2/(4 E) ((1 - ν) r2² + (3 + ν) r1²);   u(r1): r1 and r2 in the other's place
///
/// Source:   plane stress of a turning disc with a hole, derived.
/// Domain:   r1 >= 0.
[[nodiscard]] inline double growth_by_rotation(const model::SolidMaterial& m, double radius,
                                               double other_radius, double speed) {
  const double nu = m.poissons_ratio;
  return m.density * speed * speed * radius / (4.0 * m.elastic_modulus) *
         ((1.0 - nu) * radius * radius + (3.0 + nu) * other_radius * other_radius);
}

/// Pressure of a seat, both parts at one speed [Pa].
///
///   p = (δ/2)/(b (c_i/E_i + c_o/E_o)),   δ = δ0 + 2 (u_i - u_o) + 2 b (α_i T_i - α_o T_o)
///   c_i = (b² + a²)/(b² - a²) - ν_i,   c_o = (c² + b²)/(c² - b²) + ν_o,   radii a < b < c
///
/// u by growth_by_rotation() of the parts alone; δ0 diametral, as mounted and still, negative for a
/// clearance.
/// Source:   Lamé, plane stress; a radial finite element agrees to 1e-7.
/// Domain:   a seat that is loose bears no pressure and leaves both parts alone. Parts of even
///           temperature and of one section along the axis.
/// Trap:     an outer seat stands still: speed 0 there.
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
