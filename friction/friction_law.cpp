#include "friction/friction_law.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "friction/contact/contact_law.h"

namespace raceway::friction {
namespace {

constexpr std::array palmgren_parameters{PalmgrenViscous::parameters[0],
                                         PalmgrenLoad::parameters[0], PalmgrenLoad::parameters[1]};
constexpr std::array skf_parameters{SkfSliding::parameters[0], SkfSliding::parameters[1],
                                    SkfRolling::parameters[0]};

}  // namespace

std::string_view name(FrictionLaw law) {
  return law == FrictionLaw::palmgren ? "palmgren" : law == FrictionLaw::skf ? "skf" : "contact";
}

std::string_view name(F1Load load) { return load == F1Load::P0 ? "P0" : "F_b"; }

std::optional<FrictionLaw> find_friction_law(std::string_view text) {
  for (const FrictionLaw law : all_friction_laws)
    if (text == name(law)) return law;
  return std::nullopt;
}

std::span<const Parameter> parameters(FrictionLaw law) {
  if (law == FrictionLaw::palmgren) return palmgren_parameters;
  if (law == FrictionLaw::skf) return skf_parameters;
  return contact::contact_parameters;
}

bool of_the_lubricant(const Parameter& number) { return number.name == "limiting_traction"; }

std::span<const std::string_view> bearing_data(FrictionLaw law) {
  // The load moments take in all that the other moment does (tests).
  if (law == FrictionLaw::palmgren) return PalmgrenLoad::bearing_data;
  if (law == FrictionLaw::contact) return {};
  return SkfSliding::bearing_data;
}

void require_data(FrictionLaw law, const bearing::Bearing& bearing) {
  const bearing::BearingGeometry& g = bearing.geometry();
  if (law == FrictionLaw::palmgren) {
    if (std::isnan(g.static_load_rating))
      throw std::invalid_argument(
          "static_load_rating is missing: the palmgren law needs it, above 0 N");
  } else if (law == FrictionLaw::skf && g.contact_angle <= 0.0) {
    throw std::invalid_argument(
        "contact_angle = 0 deg: must be above 0 deg for the skf law, whose constants are those of "
        "angular contact ball bearings");
  }
}

}  // namespace raceway::friction
