#include "model/bearing_life.h"

#include <algorithm>
#include <cmath>

#include "bearing/contact_pressure.h"
#include "life/equivalent_load.h"
#include "life/fatigue_load.h"
#include "life/load_rating.h"
#include "life/modified_life.h"
#include "life/reference_life.h"

namespace raceway::model {
namespace {

double given_or(double given, double otherwise) { return std::isnan(given) ? otherwise : given; }

constexpr double seconds_per_hour = 3600.0;

double seconds(double million_revolutions, double speed) {
  return life::life_hours(million_revolutions, speed) * seconds_per_hour;
}

}  // namespace

BearingLife bearing_life(const LifeData& data, const bearing::Bearing& bearing,
                         const bearing::OperatingPoint& point,
                         const bearing::BearingEquilibrium& equilibrium, double viscosity) {
  const bearing::BearingGeometry& g = bearing.geometry();
  BearingLife r;
  r.load_rating = given_or(data.dynamic_load_rating, life::dynamic_load_rating(g));
  r.fatigue_load = given_or(data.fatigue_load, life::fatigue_load(g));
  r.viscosity_ratio = life::viscosity_ratio(viscosity, point.speed, g.pitch_diameter);
  r.hybrid = bearing.balls().density != bearing.rings().density ||
             bearing.balls().elastic_modulus != bearing.rings().elastic_modulus;
  const double radial = std::hypot(point.radial_load, point.radial_load_z);
  const double axial = std::abs(point.axial_load);
  r.equivalent_load = life::equivalent_load(life::load_factors(g, axial), radial, axial);
  const double a1 = life::reliability_factor(data.reliability);
  const double L10 = life::basic_rating_life(r.load_rating, r.equivalent_load);
  r.basic = seconds(a1 * L10, point.speed);
  r.modification = life::life_modification(r.viscosity_ratio,
                                           data.contamination * r.fatigue_load / r.equivalent_load);
  if (!r.hybrid) r.modified = seconds(a1 * r.modification * L10, point.speed);
  if (!equilibrium.report.converged()) return r;
  const bearing::ContactPressure pressure = largest_pressure(bearing, equilibrium);
  r.static_safety = life::static_safety(std::fmax(pressure.inner, pressure.outer));
  r.reference =
      seconds(a1 * life::reference_life(life::race_ratings(g, r.load_rating), equilibrium.balls),
              point.speed);
  return r;
}

}  // namespace raceway::model
