#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/model.h"
#include "record/parameter.h"

namespace raceway::correction {

/// Range of the time constants that a record can determine [s].
struct TimeConstantLimits {
  double shortest = 1.0, longest = 1e7;
  double record = unset;  ///< length of the record; NaN without a record
};

/// A parameter of a model that may be fitted.
struct Number {
  record::Parameter parameter{};  ///< for example "spindle.gain_1", in the units of the files
  /// Group of numbers: "gains", "time_constants", "offset", "kinematic", "scale" or "effects".
  std::string group{};
  double* place = nullptr;  ///< address of the value in the model
  double factor = 1.0;      ///< ratio of the value in the model to the value of the parameter
};

/// Returns all parameters, in the order of the file. The places point into the model, so the model
/// must live longer than the result.
[[nodiscard]] std::vector<Number> numbers(Model& model, const TimeConstantLimits& limits = {});

/// Returns the parameters without their places in the model.
[[nodiscard]] std::vector<record::Parameter> parameters(const Model& model,
                                                        const TimeConstantLimits& limits = {});

/// Returns the names of the free parameters in the order of the model. Model::free selects the free
/// parameters by name or group. If Model::free is empty, all parameters are free, except scales
/// without a prior. Parameters of user-defined effects that are off are never free. Throws
/// std::invalid_argument for an unknown name.
[[nodiscard]] std::vector<std::string> free_names(const Model& model);

/// Returns true if a name denotes a group of parameters, such as "gains".
[[nodiscard]] bool is_group(std::string_view name);

/// Returns the shortest time constant for a lag of this input [s]. For power, speed and other
/// inputs that are constant between rows, the result is at least 180 s, because a faster response
/// belongs to the kinematic law.
[[nodiscard]] double shortest_time_constant(const Input& input, const TimeConstantLimits& limits);

/// Returns the channel with this name, or the first one for an empty name; null if there is none.
[[nodiscard]] const DrivenChannel* find_channel(const Model& model, std::string_view name);

/// Returns the input of an effect: see EffectKind::input().
[[nodiscard]] Input input_of(const Effect& effect, const Model& model);

/// Returns the id of an effect with its channel, axis, column or window, if it has one:
/// "ambient-drift", "second-time-constant:ambient".
[[nodiscard]] std::string full_id(const Effect& effect);

}  // namespace raceway::correction
