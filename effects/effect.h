#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "friction/state.h"

namespace raceway::effects {

/// What the catalogue knows of one physical effect. Each effect is a struct in a file of its own
/// (see spin_friction.h); this is that struct with its types erased, for choice by name at run
/// time.
struct Description {
  std::string_view id;
  std::string_view title;      ///< one line
  std::string_view mechanism;  ///< what happens, in a sentence or two
  std::string_view formula;
  std::string_view source;
  std::span<const std::string_view> confused_with;  ///< ids of effects and names of base parameters
  std::span<const friction::Parameter> parameters;
  bool needs_equilibrium;
  /// Added friction moment [N m]; values in the order of `parameters`.
  double (*moment)(const friction::BearingState<double>& state, std::span<const double> values);
};

/// An effect that a model has switched on, with its parameter values.
struct Effect {
  const Description* description = nullptr;
  std::vector<double> values;
};

}  // namespace raceway::effects
