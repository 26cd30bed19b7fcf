#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/model.h"
#include "fit/shaft_parameters.h"

namespace raceway::fit {

/// One number of a model that may be fitted, found by its name: "f0" for the base law,
/// "spin-friction.friction_coefficient" for an effect.
struct ModelParameter {
  std::string name;
  std::string unit;                     ///< as written in files, "1" where dimensionless
  double initial = unset;               ///< default of the law
  double lower = unset, upper = unset;  ///< closed bounds
  double plausible_lower = unset, plausible_upper = unset;  ///< of an effect: met in practice
  double neutral = unset;  ///< of an effect: where it changes nothing; NaN for a shape
  int effect = -1;         ///< index into Model::effects, -1 for the base law
  std::size_t index = 0;   ///< in the values of that law
  ShaftNumber shaft = ShaftNumber::none;  ///< a number of the arrangement instead

  [[nodiscard]] double get(const Model& model) const;
  /// Throws std::invalid_argument where an arrangement cannot take the value.
  void set(Model& model, double value) const;
};

/// All that could be fitted: base law first, then the arrangement, then the effects in the order of
/// the model.
[[nodiscard]] std::vector<ModelParameter> model_parameters(const Model& model);

/// What `Model::free` names, in its order; the default where it is empty.
/// Throws std::invalid_argument for a name the model does not have (with the nearest ones), one
/// given twice, and a conformity of both grooves beside that of one.
[[nodiscard]] std::vector<ModelParameter> free_parameters(const Model& model);

/// palmgren: f0, z (y is rarely told apart from z)      skf: mu_EHL, K_rs
[[nodiscard]] std::vector<std::string> default_free(friction::FrictionLaw law);

/// The preload of an arrangement that is given as a force, which assembly makes uncertain;
/// otherwise what the law has.
[[nodiscard]] std::vector<std::string> default_free(const Model& model);

}  // namespace raceway::fit
