#include "model/bearing_life.h"

#include <algorithm>
#include <cmath>

#include "bearing/contact_pressure.h"
#include "life/equivalent_load.h"
#include "life/fatigue_load.h"
#include "life/load_rating.h"
#include "life/modified_life.h"
#include "life/reference_life.h"
#include "life/roller_life.h"

namespace raceway::model {
namespace {

double given_or(double given, double otherwise) { return std::isnan(given) ? otherwise : given; }

constexpr double seconds_per_hour = 3600.0;

double seconds(double million_revolutions, double speed) {
  return life::life_hours(million_revolutions, speed) * seconds_per_hour;
}

BearingLife rated(const LifeData& data, double load_rating, double fatigue_load, double viscosity,
                  double speed, double pitch_diameter) {
  BearingLife r;
  r.load_rating = given_or(data.dynamic_load_rating, load_rating);
  r.fatigue_load = given_or(data.fatigue_load, fatigue_load);
  r.viscosity_ratio = life::viscosity_ratio(viscosity, speed, pitch_diameter);
  return r;
}

bool hybrid(const bearing::Material& elements, const bearing::Material& rings) {
  return elements.density != rings.density || elements.elastic_modulus != rings.elastic_modulus;
}

BearingLife life_of_rollers(const LifeData& data, const bearing::RollerBearing& bearing,
                            const bearing::OperatingPoint& point,
                            const bearing::RollerEquilibrium& equilibrium, double viscosity) {
  const bearing::RollerGeometry& g = bearing.geometry();
  BearingLife r = rated(data, life::dynamic_load_rating(g), life::fatigue_load(g), viscosity,
                        point.speed, g.pitch_diameter);
  r.hybrid = hybrid(bearing.rollers(), bearing.rings());
  const double a1 = life::reliability_factor(data.reliability);
  const double radial = std::hypot(point.radial_load, point.radial_load_z);
  r.basic = seconds(a1 * life::roller_rating_life(r.load_rating, radial), point.speed);
  if (!equilibrium.report.converged()) return r;
  const double L10r = life::reference_life(life::race_ratings(g, r.load_rating), equilibrium);
  r.equivalent_load = life::roller_reference_load(r.load_rating, L10r);
  r.reference = seconds(a1 * L10r, point.speed);
  r.modification = life::roller_life_modification(
      r.viscosity_ratio, data.contamination * r.fatigue_load / r.equivalent_load);
  if (!r.hybrid) r.modified = seconds(a1 * r.modification * L10r, point.speed);
  const bearing::ContactPressure pressure = largest_pressure(bearing, equilibrium);
  r.static_safety = life::roller_static_safety(std::fmax(pressure.inner, pressure.outer));
  return r;
}

double reference_of_balls(const LifeData& data, const bearing::BearingGeometry& g,
                          double load_rating, const bearing::BearingEquilibrium& equilibrium,
                          double speed) {
  return seconds(life::reliability_factor(data.reliability) *
                     life::reference_life(life::race_ratings(g, load_rating), equilibrium.balls),
                 speed);
}

BearingLife life_of_balls(const LifeData& data, const bearing::Bearing& bearing,
                          const bearing::OperatingPoint& point,
                          const bearing::BearingEquilibrium& equilibrium, double viscosity) {
  const bearing::BearingGeometry& g = bearing.geometry();
  BearingLife r = rated(data, life::dynamic_load_rating(g), life::fatigue_load(g), viscosity,
                        point.speed, g.pitch_diameter);
  r.hybrid = hybrid(bearing.balls(), bearing.rings());
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
  r.reference = reference_of_balls(data, g, r.load_rating, equilibrium, point.speed);
  return r;
}

}  // namespace

BearingLife bearing_life(const Model& model, const bearing::OperatingPoint& point,
                         const FrictionPrediction& p) {
  const double viscosity = p.film.kinematic_viscosity;
  if (p.rollers)
    return life_of_rollers(model.life, *model.bearing.rollers(), point, *p.rollers, viscosity);
  return life_of_balls(model.life, bearing_of(model, p), point, *p.equilibrium, viscosity);
}

ReferenceLife reference_life(const Model& model, const bearing::OperatingPoint& point,
                             const FrictionPrediction& p) {
  if (p.rollers) {
    const BearingLife life = bearing_life(model, point, p);
    return {life.viscosity_ratio, life.reference};
  }
  const bearing::BearingGeometry& g = bearing_of(model, p).geometry();
  ReferenceLife life{.viscosity_ratio = life::viscosity_ratio(p.film.kinematic_viscosity,
                                                              point.speed, g.pitch_diameter)};
  if (p.equilibrium->report.converged())
    life.reference = reference_of_balls(
        model.life, g, given_or(model.life.dynamic_load_rating, life::dynamic_load_rating(g)),
        *p.equilibrium, point.speed);
  return life;
}

}  // namespace raceway::model
