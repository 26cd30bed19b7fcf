#pragma once

#include <optional>

#include "friction/contact/film.h"
#include "friction/contact/oil.h"
#include "friction/contact/rolling.h"
#include "friction/lubricant.h"
#include "record/units.h"

namespace raceway::friction::contact {

/// Inputs of the contact law in addition to the bearing, the viscosities and the fitted parameters.
struct ContactData {
  OilData oil;
  double eyring_stress = default_eyring_stress;  ///< Eyring stress τ0 of the oil [Pa]
  /// Limiting traction coefficient Γ of the film, from the key `limiting_traction` in [lubricant]
  /// [1]. If Γ is NaN, the default of the oil type is used.
  double limiting_traction = unset;
  Inlet supply = Inlet::limited;
  /// Distance from the contact centre to the edge of the oil in the inlet, divided by the
  /// semi-minor axis b of the contact [1]. starvation_factors() calls this ratio m. NaN means a
  /// flooded film.
  double inlet_over_b = unset;
  double race_roughness = 0.045 * um;   ///< roughness Rq of the race [m]
  double ball_roughness = 0.0218 * um;  ///< roughness Rq of the ball [m]
  AsperityLaw asperities;
};

/// Returns the inlet condition for a lubricant supply. `bath` floods the inlets. With any other or
/// an unknown supply, the inlets are limited: a contact gets only the oil that the preceding ball
/// leaves.
[[nodiscard]] constexpr Inlet inlet_of(std::optional<Supply> supply) {
  return supply == Supply::bath ? Inlet::flooded : Inlet::limited;
}

}  // namespace raceway::friction::contact
