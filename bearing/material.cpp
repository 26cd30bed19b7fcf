#include "bearing/material.h"

#include "bearing/validation.h"

namespace raceway::bearing {

Material steel() {
  return {.name = "steel",
          .elastic_modulus = 208 * GPa,
          .poisson_ratio = 0.3,
          .density = 7800,
          .thermal_expansion = 11.5 * per_million_K};
}

Material silicon_nitride() {
  return {.name = "silicon-nitride",
          .elastic_modulus = 310 * GPa,
          .poisson_ratio = 0.26,
          .density = 3200,
          .thermal_expansion = 3.2 * per_million_K};
}

void validate(const Material& m) {
  const std::string owner = "material " + m.name + ": ";
  require_between(owner + "elastic_modulus", m.elastic_modulus, 1 * GPa, 1200 * GPa, GPa, "GPa");
  require_between(owner + "poisson_ratio", m.poisson_ratio, 0.0, 0.49, 1.0, "");
  require_between(owner + "density", m.density, 500.0, 20000.0, 1.0, "kg/m3");
  require_between(owner + "thermal_expansion", m.thermal_expansion, 0.0, 50 * per_million_K,
                  per_million_K, "1e-6/K");
}

}  // namespace raceway::bearing
