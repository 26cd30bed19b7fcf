#pragma once

#include <string>

#include "record/units.h"

namespace raceway::bearing {

/// Elastic, inertial and thermal properties of the material of balls or rings.
struct Material {
  std::string name;
  double elastic_modulus = unset;    ///< [Pa], > 0
  double poisson_ratio = unset;      ///< [1], in [0, 0.5)
  double density = unset;            ///< [kg/m³], > 0
  double thermal_expansion = unset;  ///< coefficient of linear expansion [1/K], >= 0
};

/// Returns the properties of bearing steel (100Cr6).
[[nodiscard]] Material steel();
/// Returns the properties of hot-pressed silicon nitride (Si3N4).
[[nodiscard]] Material silicon_nitride();

/// Throws std::invalid_argument for the first value that is missing or out of range. The message
/// gives the name of this value.
void validate(const Material& material);

}  // namespace raceway::bearing
