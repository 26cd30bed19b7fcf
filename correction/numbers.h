#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"
#include "record/parameter.h"

namespace raceway::correction {

/// Range of the time constants that a record can determine [s].
struct TimeConstantLimits {
  double shortest = 1.0, longest = 1e7;
  double record = unset;  ///< length of the record; NaN without a record
};

/// Returns the limits for a record: twice the sampling interval, and half the duration of the
/// longest run. If each run has one row, the result has the default limits.
[[nodiscard]] TimeConstantLimits time_constants_of(const Series& series);

/// A parameter of a model that may be fitted.
struct Number {
  record::Parameter parameter{};  ///< such as "spindle.gain_1", in the unit of its key
  /// Group of the parameter: "gains", "time_constants", "offset", "kinematic", "scale" or
  /// "effects".
  std::string group{};
  double* place = nullptr;  ///< address of its value in the model
  double factor = 1.0;      ///< ratio of the value in the model to the value of the parameter
};

/// Returns all parameters of a model, in the order of the model file. The result has pointers into
/// the model, so the model must live longer.
[[nodiscard]] std::vector<Number> numbers(Model& model, const TimeConstantLimits& limits = {});

/// Returns copies of all parameters, without pointers into the model.
[[nodiscard]] std::vector<record::Parameter> parameters(const Model& model,
                                                        const TimeConstantLimits& limits = {});

/// Returns the names of the free parameters in the order of the model. Model::free selects the free
/// parameters by name or group. If Model::free is empty, all parameters are free, except scale
/// factors without a prior. A parameter of a user-defined effect that is off is never free, even if
/// Model::free names it. Throws std::invalid_argument for an unknown name.
[[nodiscard]] std::vector<std::string> free_names(const Model& model);

/// Returns true if a name denotes a group of parameters, such as "gains".
[[nodiscard]] bool is_group(std::string_view name);

/// Returns the lower bound of a fitted time constant for this input [s]. For a power, a speed and
/// other inputs that are constant between rows, the bound is at least 180 s, because the kinematic
/// law describes faster responses.
[[nodiscard]] double shortest_time_constant(const Input& input, const TimeConstantLimits& limits);

/// Returns the channel with this name, or the first channel for an empty name; null if there is
/// none.
[[nodiscard]] const DrivenChannel* find_channel(const Model& model, std::string_view name);

/// Returns the input of an effect: see EffectKind::input().
[[nodiscard]] Input input_of(const Effect& effect, const Model& model);

/// Returns the id of an effect, followed by its channel, axis, column or window if it has one:
/// "ambient-drift", "second-time-constant:ambient".
[[nodiscard]] std::string full_id(const Effect& effect);

}  // namespace raceway::correction
