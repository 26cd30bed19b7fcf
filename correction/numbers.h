#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/model.h"
#include "correction/series.h"
#include "record/parameter.h"

namespace raceway::correction {

/// Range of the time constants that a fit can determine from a record [s].
struct TimeConstantLimits {
  double shortest = 1.0, longest = 1e7;
  double record = unset;  ///< duration of the longest run; NaN without a record
};

/// Returns the limits for a record. The lower limit is twice the sampling interval, and the upper
/// limit is half the duration of the longest run. If each run has one row, the result has the
/// default limits.
[[nodiscard]] TimeConstantLimits time_constants_of(const Series& series);

/// Parameter of a model that a fit may change, with the address of its value in the model.
struct Number {
  /// Parameter such as "spindle.gain_1", with its value in the unit of the model file.
  record::Parameter parameter{};
  /// Group of the parameter: "gains", "time_constants", "offset", "kinematic", "scale" or
  /// "effects".
  std::string group{};
  double* place = nullptr;  ///< address of the parameter's value in the model
  /// Unit conversion: value in the model divided by value in the model file.
  double factor = 1.0;
};

/// Returns all parameters of a model, in the order of the model file. The result has pointers into
/// the model, so the model must live longer than the result.
[[nodiscard]] std::vector<Number> numbers(Model& model, const TimeConstantLimits& limits = {});

/// Returns copies of all parameters, without pointers into the model.
[[nodiscard]] std::vector<record::Parameter> parameters(const Model& model,
                                                        const TimeConstantLimits& limits = {});

/// Returns the names of the free parameters in the order of the model. Model::free lists the names
/// or groups of free parameters. If Model::free is empty, all parameters are free, except scale
/// factors without a prior. A parameter of a user-defined effect that is off is never free, even if
/// Model::free names it. Throws std::invalid_argument for an unknown name.
[[nodiscard]] std::vector<std::string> free_names(const Model& model);

/// Returns true if a name denotes a group of parameters, such as "gains".
[[nodiscard]] bool is_group(std::string_view name);

/// Returns the lower bound of a fitted time constant for this input [s]. The bound is at least 180
/// s for inputs that are constant between rows, such as powers and speeds, because the kinematic
/// law describes faster responses.
[[nodiscard]] double shortest_time_constant(const Input& input, const TimeConstantLimits& limits);

/// Returns the channel with this name, or the first channel for an empty name; null if there is
/// none.
[[nodiscard]] const DrivenChannel* find_channel(const Model& model, std::string_view name);

/// Returns the input of an effect: see EffectKind::input().
[[nodiscard]] Input input_of(const Effect& effect, const Model& model);

/// Returns the full id of an effect: "ambient-drift", or "second-time-constant:ambient" for an
/// effect with a channel, axis, column or window.
[[nodiscard]] std::string full_id(const Effect& effect);

}  // namespace raceway::correction
