#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Response over time to a step of one input, from rest. Each part is a lag: gain (1 - exp(-t/T)).
struct StepResponse {
  std::string name{};   ///< name of the channel or effect
  std::string input{};  ///< readable name of the input that steps
  double step = 1.0;    ///< size of the step in `unit`
  std::string unit{};   ///< "K"; empty for an input without a unit
  struct Part {
    std::string name{};            ///< "section 1", or the effect that added the part
    double gain = unset;           ///< final displacement after the step [m]
    double time_constant = unset;  ///< [s]
  };
  std::vector<Part> parts{};
  double at_once = 0.0;               ///< instant part without a lag [m]
  double sensor_time_constant = 0.0;  ///< time constant of a slow sensor [s]
  /// Displacement for each sample [m]; used for published coefficients instead of `parts`.
  std::vector<double> sampled{};
  double sampling = unset;  ///< [s]
  /// Effects that change the response under other conditions: at other speeds, during cooling, or
  /// with the coolant off.
  std::vector<std::string> changed_by{};
};

/// Returns the step responses of all channels of a model and of all effects that are lags. An
/// effect on a channel is part of the response of that channel. The step is 1 K, W or m/min, or
/// 1000 rpm. The record determines the input values for a delay element (the median above zero, the
/// largest, and the lowest below zero) and the duration for published coefficients. Effects without
/// a lag and the kinematic law are left out.
[[nodiscard]] std::vector<StepResponse> step_responses(const Model& model,
                                                       const record::Record& record);

}  // namespace raceway::correction
