#include "friction/roller_friction.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "friction/viscous_drag.h"

namespace raceway::friction {
namespace {

constexpr std::array roller_palmgren_parameters{PalmgrenViscous::parameters[0],
                                                RollerPalmgrenLoad::parameters[0]};
constexpr SkfRollerConstants skf_series_10;

RingSize ring_size(const RollerState& s) {
  return {s.bearing->geometry().bore, s.bearing->geometry().outer_diameter};
}

}  // namespace

std::string_view name(RollerLoad load) { return load == RollerLoad::F_r ? "F_r" : "rollers"; }

std::string_view name(RollerLaw law) { return law == RollerLaw::palmgren ? "palmgren" : "skf"; }

std::optional<RollerLaw> find_roller_law(std::string_view text) {
  for (const RollerLaw law : {RollerLaw::palmgren, RollerLaw::skf})
    if (text == name(law)) return law;
  return std::nullopt;
}

double counted_load(const RollerState& s) {
  if (s.counted == RollerLoad::F_r) return s.radial_load;
  return std::max(s.radial_load, (s.inner_sum + s.outer_sum) / (2.0 * roller_sum_ratio));
}

double RollerPalmgrenLoad::moment(const RollerState& s, double f1) {
  return f1 * counted_load(s) * s.bearing->geometry().pitch_diameter;
}

double usual_roller_f0(std::optional<Supply> supply) {
  if (!supply) return PalmgrenViscous::parameters[0].initial;
  switch (*supply) {
    case Supply::grease:
      return 0.8;
    case Supply::bath:
      return 3.0;
    case Supply::jet:
      return 6.0;
    case Supply::oil_air:
      break;
  }
  return 1.5;
}

double RollerSkf::sliding(const RollerState& s, double mu_bl, double mu_EHL) {
  const double d_m = ring_size(s).mean_diameter();
  const double mu =
      sliding_coefficient(mu_bl, mu_EHL, boundary_share(s.speed, s.kinematic_viscosity, d_m));
  return mu * skf_series_10.S2 * (d_m / mm) * counted_load(s) * N_mm;
}

double RollerSkf::rolling(const RollerState& s, double K_rs) {
  const RingSize ring = ring_size(s);
  const double d_m = ring.mean_diameter();
  const double nu_n = (s.kinematic_viscosity / mm2_per_s) * (s.speed / rpm);
  const double load = counted_load(s);
  if (nu_n <= 0.0 || load <= 0.0) return 0.0;
  return inlet_shear_factor(s.speed, s.kinematic_viscosity, d_m) *
         replenishment_factor(K_rs, s.speed, s.kinematic_viscosity, ring, skf_series_10.K_Z) *
         skf_series_10.R1 * std::pow(d_m / mm, 2.41) * std::pow(load, 0.31) * std::pow(nu_n, 0.6) *
         N_mm;
}

std::span<const Parameter> parameters(RollerLaw law) {
  if (law == RollerLaw::palmgren) return roller_palmgren_parameters;
  return RollerSkf::parameters;
}

void require_data(RollerLaw law, const bearing::RollerBearing& bearing) {
  const bearing::RollerGeometry& g = bearing.geometry();
  if (law != RollerLaw::skf) return;
  if (std::isnan(g.bore))
    throw std::invalid_argument("bore is missing: the skf law needs it, above 0 mm");
  if (std::isnan(g.outer_diameter))
    throw std::invalid_argument("outer_diameter is missing: the skf law needs it, above 0 mm");
}

BaseMoments<double> base_moments(RollerLaw law, const RollerState& s,
                                 std::span<const double> values) {
  if (law == RollerLaw::palmgren)
    return {RollerPalmgrenLoad::moment(s, values[1]),
            palmgren_viscous_moment(values[0], s.kinematic_viscosity, s.speed,
                                    s.bearing->geometry().pitch_diameter)};
  return {RollerSkf::sliding(s, values[0], values[1]), RollerSkf::rolling(s, values[2])};
}

HeatSplit split_heat(const RollerState& s, const BaseMoments<double>& moments) {
  const double sum = s.inner_sum + s.outer_sum;
  const double inner = (sum > 0.0 ? s.inner_sum / sum : 0.5) * moments.load;
  return {.inner = power_loss(inner + 0.5 * moments.viscous, s.speed),
          .outer = power_loss((moments.load - inner) + 0.5 * moments.viscous, s.speed)};
}

double roller_conductance(const bearing::RollerBearing& bearing,
                          const bearing::RollerEquilibrium& equilibrium, double roller_conductivity,
                          double ring_conductivity) {
  const bearing::RollerGeometry& g = bearing.geometry();
  const double L = g.roller_length;
  const auto resistance = [&](bearing::Race race, double load) {
    const double b = bearing.contact().half_width(race, load / L);
    return ((std::log(4.0 * L / b) - 1.0) / ring_conductivity +
            std::log(2.0 * g.roller_diameter / b) / roller_conductivity) /
           (pi * L);
  };
  double sum = 0.0;
  for (const bearing::LoadedRoller& r : equilibrium.rollers)
    if (r.inner_load > 0.0 && r.outer_load > 0.0)
      sum += 1.0 / (resistance(bearing::Race::inner, r.inner_load) +
                    resistance(bearing::Race::outer, r.outer_load));
  return sum;
}

}  // namespace raceway::friction
