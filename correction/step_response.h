#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Displacement over time t after a step of one input, from rest: a sum of terms gain (1 -
/// exp(-t/T)), one for each lag with the time constant T, and an instant displacement.
struct StepResponse {
  std::string name{};   ///< name of the channel or effect
  std::string input{};  ///< description of the input that changes in a step
  double step = 1.0;    ///< size of the step in `unit`
  std::string unit{};   ///< unit of the input, such as "K"; "1" or empty for no unit
  struct Part {
    /// Name of the lag: "section 1" and so on, "delay element", or the effect that adds the lag.
    std::string name{};
    double gain = unset;           ///< final displacement after the step [m]
    double time_constant = unset;  ///< [s]
  };
  std::vector<Part> parts{};
  double at_once = 0.0;               ///< instant displacement [m]
  double sensor_time_constant = 0.0;  ///< time constant of the effect sensor-lag [s]
  /// Displacement at the times 0, `sampling`, 2 `sampling` and so on [m]. Only for a transfer
  /// function with published coefficients, where this list replaces `parts`; otherwise empty.
  std::vector<double> sampled{};
  double sampling = unset;  ///< time between two values of `sampled` [s]; NaN if it is empty
  /// Ids of effects that this response does not include. They change the response at speeds above
  /// 0, while the machine cools down, or while the coolant is off.
  std::vector<std::string> changed_by{};
};

/// Returns the step responses of all channels of a model and of all effects with a lag. The
/// response of a channel includes the effects on this channel, except StepResponse::changed_by. The
/// step is 1000 rpm for a speed, otherwise one unit of the input, such as 1 K, 1 W or 1 m/min. For
/// a delay element, the step sizes are values of its input in the record: the largest value, the
/// median of the values above zero, and the lowest value below zero. If the median nearly equals
/// the largest value, the step of the median is omitted. For a transfer function with published
/// coefficients, the response is computed over half the duration of the longest run. The result
/// contains neither effects without a lag nor the kinematic law.
[[nodiscard]] std::vector<StepResponse> step_responses(const Model& model,
                                                       const record::Record& record);

}  // namespace raceway::correction
