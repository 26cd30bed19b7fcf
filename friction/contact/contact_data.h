#pragma once

#include <optional>

#include "friction/contact/film.h"
#include "friction/contact/oil.h"
#include "friction/contact/rolling.h"
#include "friction/lubricant.h"
#include "record/units.h"

namespace raceway::friction::contact {

/// Inputs of the contact law besides bearing, viscosities and its own parameters.
struct ContactData {
  OilData oil;
  double eyring_stress = default_eyring_stress;  ///< τ0 [Pa]
  /// Γ of the film as entered with the oil, for any law; NaN: by the type of oil [1].
  double limiting_traction = unset;
  Inlet supply = Inlet::limited;
  double inlet_over_b = unset;          ///< m of starvation_factors() [1]; unset: flooded film
  double race_roughness = 0.045 * um;   ///< Rq [m]
  double ball_roughness = 0.0218 * um;  ///< Rq [m]; of both together 0.05 um
  AsperityLaw asperities;
};

/// `bath` floods the inlets of the contacts, all else leaves them what the balls before have left.
[[nodiscard]] constexpr Inlet inlet_of(std::optional<Supply> supply) {
  return supply == Supply::bath ? Inlet::flooded : Inlet::limited;
}

}  // namespace raceway::friction::contact
