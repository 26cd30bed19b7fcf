#include "correction/prior.h"

#include <cmath>

namespace raceway::correction {

std::vector<NumberPrior> computed_priors(const Model& model) {
  constexpr double share = 0.2, of_exponent = 0.1;
  std::vector<NumberPrior> list;
  const auto add = [&](std::string name, double value, double std) {
    if (std > 0.0) list.push_back({std::move(name), {.value = value, .std = std}});
  };
  for (const DrivenChannel& c : model.channels)
    if (c.element) add(c.name + ".scale", c.scale, share * std::abs(c.scale));
  if (const auto& law = model.kinematic) {
    add("kinematic.A", law->A, share * std::abs(law->A));
    add("kinematic.B", law->B, of_exponent);
    add("kinematic.C", law->C, share * std::abs(law->C));
  }
  return list;
}

}  // namespace raceway::correction
