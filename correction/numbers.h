#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/model.h"
#include "record/parameter.h"

namespace raceway::correction {

/// Between which time constants a record can tell anything [s].
struct TimeConstantLimits {
  double shortest = 1.0, longest = 1e7;
  double record = unset;  ///< its length, where there is one
};

/// One number of a model that may be fitted.
struct Number {
  record::Parameter parameter{};  ///< named "spindle.gain_1", in the units of the files
  std::string group{};  ///< "gains", "time_constants", "offset", "kinematic", "scale" or "effects"
  double* place = nullptr;  ///< in the model
  double factor = 1.0;      ///< what stands there is the value of the parameter times it
};

/// All of them, in the order of the file. They point into the model, which outlives them.
[[nodiscard]] std::vector<Number> numbers(Model& model, const TimeConstantLimits& limits = {});

/// The parameters without places in the model.
[[nodiscard]] std::vector<record::Parameter> parameters(const Model& model,
                                                        const TimeConstantLimits& limits = {});

/// Names of the parameters of a model that a list of names and groups means, in the order of the
/// model; without a list all but scales, and those with a prior. Throws std::invalid_argument for a
/// name that is none.
[[nodiscard]] std::vector<std::string> free_names(const Model& model);

/// Returns true for the name of a group of parameters, as "gains".
[[nodiscard]] bool is_group(std::string_view name);

/// The shortest time constant of a lag of that input [s]. What follows power or speed faster than a
/// body does is the law of instant displacement.
[[nodiscard]] double shortest_time_constant(const Input& input, const TimeConstantLimits& limits);

/// The channel of that name, or the first one for an empty name; null where there is none.
[[nodiscard]] const DrivenChannel* find_channel(const Model& model, std::string_view name);

/// Input of an effect: see EffectKind::input().
[[nodiscard]] Input input_of(const Effect& effect, const Model& model);

/// "ambient-drift", or "second-time-constant:ambient" where it says which channel or axis.
[[nodiscard]] std::string full_id(const Effect& effect);

}  // namespace raceway::correction
