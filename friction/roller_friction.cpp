#include "friction/roller_friction.h"

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

std::optional<FrictionLaw> find_roller_law(std::string_view text) {
  for (const FrictionLaw law : roller_friction_laws)
    if (text == name(law)) return law;
  return std::nullopt;
}

double counted_load(const RollerState& s) {
  if (s.counted == F1Load::F_r) return s.radial_load;
  const double carried = (s.inner_sum + s.outer_sum) / (2.0 * roller_sum_ratio);
  // In this order a load that is not a number stays one.
  return carried < s.radial_load ? s.radial_load : carried;
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

std::span<const Parameter> roller_parameters(FrictionLaw law) {
  if (law == FrictionLaw::roller_palmgren) return roller_palmgren_parameters;
  return RollerSkf::parameters;
}

void require_data(FrictionLaw law, const bearing::RollerBearing& bearing) {
  const bearing::RollerGeometry& g = bearing.geometry();
  if (law != FrictionLaw::roller_skf) return;
  if (std::isnan(g.bore))
    throw std::invalid_argument("bore is missing: the law skf needs a bore above 0 mm");
  if (std::isnan(g.outer_diameter))
    throw std::invalid_argument(
        "outer_diameter is missing: the law skf needs an outer diameter above 0 mm");
}

BaseMoments<double> roller_moments(FrictionLaw law, const RollerState& s,
                                   std::span<const double> values) {
  if (law == FrictionLaw::roller_palmgren)
    return {RollerPalmgrenLoad::moment(s, values[1]),
            palmgren_viscous_moment(values[0], s.kinematic_viscosity, s.speed,
                                    s.bearing->geometry().pitch_diameter)};
  return {RollerSkf::sliding(s, values[0], values[1]), RollerSkf::rolling(s, values[2])};
}

RollerState roller_state(const BearingState<double>& s) {
  RollerState state{.bearing = s.rollers,
                    .counted = s.f1_load,
                    .speed = s.speed,
                    .radial_load = s.radial_load,
                    .inner_sum = unset,
                    .outer_sum = unset,
                    .kinematic_viscosity = s.kinematic_viscosity};
  if (s.roller_equilibrium && s.roller_equilibrium->report.converged()) {
    state.inner_sum = s.roller_equilibrium->inner_sum();
    state.outer_sum = s.roller_equilibrium->outer_sum();
  }
  return state;
}

BaseMoments<double> roller_moments(FrictionLaw law, const BearingState<double>& state,
                                   std::span<const double> values) {
  return roller_moments(law, roller_state(state), values);
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
