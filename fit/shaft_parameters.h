#pragma once

#include <string_view>
#include <vector>

#include "fit/model.h"

namespace raceway::fit {

/// Numbers of an arrangement that may be fitted to its displacement.
///
///   preload            force on each side at standstill
///   conformity         of both grooves, where they are equal in the model
///   contact_angle      free contact angle; the force of preload stays
///
/// Those of the bearing are of all bearings in the arrangement.
enum class ShaftNumber {
  none,
  preload,
  inner_conformity,
  outer_conformity,
  conformity,
  contact_angle
};

struct ShaftParameter {
  ShaftNumber number = ShaftNumber::none;
  std::string_view name, unit;  ///< as in files
  double lower, upper;          ///< in `unit`
};

/// Those that a model has: none without a shaft, no preload where it is not given as a force,
/// nothing of the bearing where the sets have different ones.
[[nodiscard]] std::vector<ShaftParameter> shaft_parameters(const Model& model);

/// In the unit of files. Throws std::invalid_argument where the model cannot take the value.
[[nodiscard]] double shaft_value(const Model& model, ShaftNumber number);
void set_shaft_value(Model& model, ShaftNumber number, double value);

}  // namespace raceway::fit
