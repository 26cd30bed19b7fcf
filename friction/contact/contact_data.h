#pragma once

#include <optional>

#include "friction/contact/film.h"
#include "friction/contact/oil.h"
#include "friction/contact/rolling.h"
#include "friction/lubricant.h"
#include "record/units.h"

namespace raceway::friction::contact {

/// Inputs of the contact law in addition to bearing, viscosities and its own parameters.
struct ContactData {
  OilData oil;
  double eyring_stress = default_eyring_stress;  ///< τ0 [Pa]
  /// Limiting traction Γ of the film, from the key `limiting_traction` in [lubricant] [1]. The key
  /// is read with every friction law. If Γ is NaN, the value of the oil type is used.
  double limiting_traction = unset;
  Inlet supply = Inlet::limited;
  double inlet_over_b = unset;          ///< m of starvation_factors() [1]; unset: flooded film
  double race_roughness = 0.045 * um;   ///< Rq [m]
  double ball_roughness = 0.0218 * um;  ///< Rq [m]; composite roughness 0.05 um
  AsperityLaw asperities;
};

/// Returns the inlet condition. `bath` floods the inlets. With any other or an unknown supply, a
/// contact gets only the oil that the preceding ball leaves.
[[nodiscard]] constexpr Inlet inlet_of(std::optional<Supply> supply) {
  return supply == Supply::bath ? Inlet::flooded : Inlet::limited;
}

}  // namespace raceway::friction::contact
