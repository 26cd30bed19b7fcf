#include "bearing/roller_bearing.h"

#include <sstream>
#include <stdexcept>

#include "bearing/balls.h"
#include "bearing/validation.h"

namespace raceway::bearing {
namespace {

constexpr double longest_crowned = 2.5;  // L/D up to which the whole length is crowned

double strain_compliance(const Material& m) {
  return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.elastic_modulus;
}

void require_room(const RollerGeometry& g) {
  if (g.roller_count * g.roller_diameter > 0.98 * pi * g.pitch_diameter) {
    std::ostringstream text;
    text << "roller_count = " << g.roller_count << ": at most "
         << std::floor(0.98 * pi * g.pitch_diameter / g.roller_diameter) << " rollers of "
         << g.roller_diameter / mm << " mm fit on a pitch circle of " << g.pitch_diameter / mm
         << " mm";
    throw std::invalid_argument(text.str());
  }
}

LineContact line_contact(const RollerGeometry& g, const Material& rollers, const Material& rings) {
  const double k = strain_compliance(rollers) + strain_compliance(rings);
  const double both = 35948.0 * std::pow(g.roller_length / mm, 8.0 / 9.0) /
                      static_cast<double>(lamina_count) * std::pow(mm, -10.0 / 9.0);
  const double g_ratio = g.diameter_ratio();
  return {.stiffness = std::pow(2.0, 10.0 / 9.0) * both * (2.0 * strain_compliance(steel()) / k),
          .compliance = k,
          .inner_radius = 0.5 * g.roller_diameter * (1.0 - g_ratio),
          .outer_radius = 0.5 * g.roller_diameter * (1.0 + g_ratio)};
}

}  // namespace

RollerGeometry validated(const RollerGeometry& g) {
  require_between("roller_count", g.roller_count == 0 ? unset : g.roller_count, 4, 200, 1.0, "");
  require_between("roller_diameter", g.roller_diameter, 0.5 * mm, 300 * mm, mm, "mm");
  require_between("roller_length", g.roller_length, 0.5 * mm, 10.0 * g.roller_diameter, mm, "mm");
  require_between("pitch_diameter", g.pitch_diameter, 2.0 * g.roller_diameter, 5000 * mm, mm, "mm");
  require_room(g);
  require_between("radial_clearance", g.radial_clearance, -100 * um, 1000 * um, um, "um");
  if (g.taper != 0.0) require_between("taper", g.taper, 5.0, 100.0, 1.0, "");
  if (!std::isnan(g.bore))
    require_between("bore", g.bore, 0.0, g.raceway_diameter(Race::inner), mm, "mm");
  if (!std::isnan(g.outer_diameter))
    require_between("outer_diameter", g.outer_diameter, g.raceway_diameter(Race::outer),
                    2.0 * g.raceway_diameter(Race::outer), mm, "mm");
  if (!std::isnan(g.width)) require_between("width", g.width, g.roller_length, 5000 * mm, mm, "mm");
  if (!std::isnan(g.static_load_rating))
    require_between("static_load_rating", g.static_load_rating, 1.0, 1e9, 1.0, "N");
  return g;
}

double roller_relief(const RollerGeometry& g, double x) {
  if (g.profile == RollerProfile::none) return 0.0;
  const double D = g.roller_diameter, L = g.roller_length;
  if (L <= longest_crowned * D) {
    const double t = 2.0 * x / L;
    return -0.00035 * D * std::log1p(-t * t);
  }
  const double crowned = longest_crowned * D;
  const double t = (2.0 * std::abs(x) - L + crowned) / crowned;
  return t > 0.0 ? -0.0005 * D * std::log1p(-t * t) : 0.0;
}

RollerBearing::RollerBearing(const RollerGeometry& geometry, const Material& rollers,
                             const Material& rings)
    : geometry_(validated(geometry)), rollers_(rollers), rings_(rings) {
  validate(rollers);
  validate(rings);
  contact_ = line_contact(geometry_, rollers_, rings_);
  const double D = geometry_.roller_diameter, L = geometry_.roller_length;
  roller_mass_ = rollers_.density * pi / 4.0 * D * D * L;
  for (std::size_t j = 0; j < lamina_count; ++j) {
    positions_[j] = L * ((static_cast<double>(j) + 0.5) / static_cast<double>(lamina_count) - 0.5);
    relief_[j] = roller_relief(geometry_, positions_[j]);
  }
  for (int k = 0; k < geometry_.roller_count; ++k) {
    const double azimuth = azimuth_of_ball(k, geometry_.roller_count);
    azimuths_.push_back({azimuth, std::cos(azimuth), std::sin(azimuth)});
  }
}

double RollerBearing::centrifugal_force(double speed) const {
  const double cage = 0.5 * speed * (1.0 - geometry_.diameter_ratio());
  return roller_mass_ * 0.5 * geometry_.pitch_diameter * cage * cage;
}

}  // namespace raceway::bearing
