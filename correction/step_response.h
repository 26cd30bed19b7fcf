#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Displacement over time after a step of one input, from rest: a sum of lags gain (1 - exp(-t/T))
/// and an instant displacement.
struct StepResponse {
  std::string name{};   ///< name of the channel or effect
  std::string input{};  ///< description of the input that steps
  double step = 1.0;    ///< size of the step in `unit`
  std::string unit{};   ///< such as "K"; "1" or empty for an input without a unit
  struct Part {
    std::string name{};   ///< "section 1", ..., "delay element", or the effect that adds the lag
    double gain = unset;  ///< final displacement after the step [m]
    double time_constant = unset;  ///< [s]
  };
  std::vector<Part> parts{};
  double at_once = 0.0;               ///< instant displacement [m]
  double sensor_time_constant = 0.0;  ///< time constant of the effect sensor-lag [s]
  /// Displacement at time steps of `sampling`, the first at time 0 [m]. For published coefficients,
  /// this list replaces `parts`.
  std::vector<double> sampled{};
  double sampling = unset;  ///< time between two values of `sampled` [s]; NaN without them
  /// Ids of effects that change the response at other speeds, while the machine cools down, or with
  /// the coolant off.
  std::vector<std::string> changed_by{};
};

/// Returns the step responses of all channels of a model and of all effects with a lag. The
/// response of a channel includes the effects on this channel. The step is 1000 rpm for a speed,
/// otherwise one unit of the input, such as 1 K, 1 W or 1 m/min. For a delay element, the steps are
/// inputs of the record: the largest input, the median of the inputs above zero unless it is nearly
/// equal to the largest input, and the lowest input below zero. Responses with published
/// coefficients last half of the longest run. Effects without a lag and the kinematic law are left
/// out.
[[nodiscard]] std::vector<StepResponse> step_responses(const Model& model,
                                                       const record::Record& record);

}  // namespace raceway::correction
