#include "friction/friction_law.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "friction/contact/contact_law.h"
#include "friction/roller_friction.h"
#include "friction/torque_table.h"

namespace raceway::friction {
namespace {

constexpr std::array palmgren_parameters{PalmgrenViscous::parameters[0],
                                         PalmgrenLoad::parameters[0], PalmgrenLoad::parameters[1]};
constexpr std::array powers_parameters{PalmgrenViscous::parameters[0], PalmgrenLoad::parameters[0],
                                       PalmgrenLoad::parameters[1], PowersViscous::parameters[0],
                                       PowersViscous::parameters[1]};
constexpr std::array skf_parameters{SkfSliding::parameters[0], SkfSliding::parameters[1],
                                    SkfRolling::parameters[0]};

}  // namespace

std::string_view name(FrictionLaw law) {
  switch (law) {
    case FrictionLaw::palmgren:
    case FrictionLaw::roller_palmgren:
      return "palmgren";
    case FrictionLaw::skf:
    case FrictionLaw::roller_skf:
      return "skf";
    case FrictionLaw::table:
      return "table";
    case FrictionLaw::powers:
      return "powers";
    case FrictionLaw::contact_powers:
      return "contact-powers";
    case FrictionLaw::contact:
      break;
  }
  return "contact";
}

std::string_view name(F1Load load) {
  switch (load) {
    case F1Load::P0:
      return "P0";
    case F1Load::F_b:
      return "F_b";
    case F1Load::F_r:
      return "F_r";
    case F1Load::rollers:
      break;
  }
  return "rollers";
}

std::optional<FrictionLaw> find_friction_law(std::string_view text) {
  for (const FrictionLaw law : all_friction_laws)
    if (text == name(law)) return law;
  return std::nullopt;
}

std::span<const Parameter> parameters(FrictionLaw law) {
  if (law == FrictionLaw::palmgren) return palmgren_parameters;
  if (has_fitted_exponents(law)) return powers_parameters;
  if (law == FrictionLaw::skf) return skf_parameters;
  if (law == FrictionLaw::table) return TorqueTable::parameters;
  if (of_rollers(law)) return roller_parameters(law);
  return contact::contact_parameters;
}

bool of_the_lubricant(const Parameter& number) { return number.name == "limiting_traction"; }

std::span<const std::string_view> bearing_data(FrictionLaw law) {
  if (needs_equilibrium(law) || law == FrictionLaw::table || of_rollers(law)) return {};
  // The load moments take in all that the other moment does (tests).
  if (has_palmgren_load(law)) return PalmgrenLoad::bearing_data;
  return SkfSliding::bearing_data;
}

BaseMoments<double> table_moments(const BearingState<double>& state,
                                  std::span<const double> values) {
  if (!state.table) return {unset, unset};
  const double load = state.table->load_moment(state);
  return {values[0] * load, values[0] * (state.table->moment(state) - load)};
}

BaseMoments<double> contact_powers_moments(const BearingState<double>& state,
                                           std::span<const double> values) {
  if (!state.equilibrium || !state.equilibrium->report.converged()) return {unset, unset};
  const bearing::Balls& balls = state.equilibrium->balls;
  const auto Z = static_cast<double>(balls.size());
  BearingState<double> thrust = state;
  thrust.radial_load = 0.0;
  thrust.axial_load = Z * std::sin(ContactPowers::angle_of_thrust(*state.bearing));
  const BaseMoments<double> at_1_N = base_moments(FrictionLaw::powers, thrust, values);
  // Under thrust alone, the moments of `powers` are proportional to powers of the load.
  double load_sum = 0.0, viscous_sum = 0.0;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    const bearing::BallEquilibrium& ball = balls.distinct()[k];
    for (const double load : {ball.inner_load, ball.outer_load}) {
      if (load <= 0.0) continue;
      const double ln_load = std::log(load);
      load_sum += balls.weight(k) * std::exp((1.0 + values[2]) * ln_load);
      viscous_sum += balls.weight(k) * std::exp(values[4] * ln_load);
    }
  }
  return {at_1_N.load * load_sum / (2.0 * Z), at_1_N.viscous * viscous_sum / (2.0 * Z)};
}

void require_data(FrictionLaw law, const bearing::Bearing& bearing) {
  const bearing::BearingGeometry& g = bearing.geometry();
  if (has_palmgren_load(law)) {
    if (std::isnan(g.static_load_rating))
      throw std::invalid_argument("static_load_rating is missing: the law " +
                                  std::string(name(law)) + " needs a rating above 0 N");
  } else if (law == FrictionLaw::skf && g.contact_angle <= 0.0) {
    throw std::invalid_argument(
        "contact_angle = 0 deg: must be above 0 deg for the skf law, whose constants are for "
        "angular contact ball bearings");
  }
}

}  // namespace raceway::friction
