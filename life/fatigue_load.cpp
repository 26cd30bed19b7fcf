#include "life/fatigue_load.h"

#include <algorithm>
#include <cmath>

#include "bearing/hertz.h"
#include "life/load_rating.h"

namespace raceway::life {

double fatigue_load(const bearing::BearingGeometry& g) {
  if (!(g.contact_angle <= steepest_radial_angle + 1e-9)) return unset;
  constexpr double endurance = 1500 * MPa, reference_diameter = 100 * mm;
  const bearing::Material steel{.name = "steel of ISO 281",
                                .elastic_modulus = 207 * GPa,
                                .poisson_ratio = 0.3,
                                .density = 7800,
                                .thermal_expansion = 0.0};
  const auto limit = [&](bearing::Race race) {
    const bearing::HertzContact c =
        bearing::hertz_contact(bearing::groove_curvature(g, race, g.contact_angle), steel, steel);
    return std::pow(endurance / c.peak_pressure(1.0), 3);  // pressure grows with the cube root
  };
  const double ball = std::min(limit(bearing::Race::inner), limit(bearing::Race::outer));
  const double size = g.pitch_diameter > reference_diameter
                          ? std::sqrt(reference_diameter / g.pitch_diameter)
                          : 1.0;
  return 0.2288 * g.ball_count * ball * std::cos(g.contact_angle) * size;
}

}  // namespace raceway::life
