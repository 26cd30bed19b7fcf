#include "model/changed_bearing.h"

#include <cmath>
#include <stdexcept>

namespace raceway::model {
namespace {

constexpr double heavy = 5000.0;  // balls beyond are of steel, others of silicon nitride [kg/m³]

bearing::Material blend(const bearing::Material& a, const bearing::Material& b, double share) {
  const auto between = [&](double x, double y) { return x + share * (y - x); };
  return {.name = a.name,
          .elastic_modulus = between(a.elastic_modulus, b.elastic_modulus),
          .poisson_ratio = between(a.poisson_ratio, b.poisson_ratio),
          .density = between(a.density, b.density),
          .thermal_expansion = between(a.thermal_expansion, b.thermal_expansion)};
}

}  // namespace

std::shared_ptr<const bearing::Bearing> changed_bearing(const bearing::Bearing& entered,
                                                        const effects::Condition& c) {
  bearing::BearingGeometry g = entered.geometry();
  if (c.radial_growth != 0.0) {
    if (g.contact_angle > 0.0) {
      const double cosine =
          std::cos(g.contact_angle) + c.radial_growth / g.groove_centre_distance();
      if (!(cosine > 0.0 && cosine < 1.0)) return nullptr;
      g.contact_angle = std::acos(cosine);
    } else {
      g.radial_clearance -= 2.0 * c.radial_growth;
    }
  }
  bearing::Material balls = entered.balls();
  if (c.other_balls != 0.0)
    balls = blend(balls, balls.density > heavy ? bearing::silicon_nitride() : bearing::steel(),
                  c.other_balls);
  try {
    return std::make_shared<const bearing::Bearing>(g, balls, entered.rings());
  } catch (const std::invalid_argument&) {
    return nullptr;  // outside what a bearing can be
  }
}

}  // namespace raceway::model
