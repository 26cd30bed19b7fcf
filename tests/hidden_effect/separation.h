#pragma once

#include <span>
#include <string_view>

#include "tests/hidden_effect/generator.h"

namespace hidden_effect {

/// How much of a hidden effect a rig's plan shows, from the torque without noise.
struct Visibility {
  double detection = 0.0;   ///< lambda_det: misfit over sigma, squared, once the law's own factors
                            ///< are refitted
  double separation = 0.0;  ///< lambda_sep: the same with the best wrong entry of the catalogue
  /// Chance that the right one ranks first. The gap to one rival is normal with mean lambda and
  /// variance 4 lambda, so it wins with Phi(sqrt(lambda)/2); the odds against several rivals add.
  double right_first = 1.0;
  std::string_view nearest;  ///< which one that is
};

/// Refits the factors of the law, f0 and z or that of rolling, alone, then with each entry of the
/// catalogue but those that are right, by a Levenberg-Marquardt method on the generator's own
/// formulas.
[[nodiscard]] Visibility visibility(const Rig& rig);

}  // namespace hidden_effect
