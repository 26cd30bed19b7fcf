#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "record/record.h"

namespace raceway::correction {

/// Response to a step of one input over time, from rest. A part is a lag: gain (1 - exp(-t/T)).
struct StepResponse {
  std::string name{};   ///< of the channel or the effect
  std::string input{};  ///< that steps, as people read it
  double step = 1.0;    ///< how far, in `unit`
  std::string unit{};   ///< "K"; empty where what steps has none
  struct Part {
    std::string name{};            ///< "section 1", or the effect that brought it
    double gain = unset;           ///< where it leads to [m]
    double time_constant = unset;  ///< [s]
  };
  std::vector<Part> parts{};
  double at_once = 0.0;               ///< what comes without any lag [m]
  double sensor_time_constant = 0.0;  ///< of a sensor that follows late [s]
  /// For printed coefficients instead of parts: displacement sample by sample [m].
  std::vector<double> sampled{};
  double sampling = unset;  ///< [s]
  /// Effects with which the channel answers otherwise than drawn: at other speeds, in falling, with
  /// the coolant off.
  std::vector<std::string> changed_by{};
};

/// Step responses of all channels of a model and of the effects that are lags, to a step of 1 K, W
/// or m/min, or 1000 rpm. The record gives the inputs at which a delay element is shown (the
/// median above zero, the largest and the least below zero) and the duration for printed
/// coefficients. Effects without a lag and the kinematic law are left out.
[[nodiscard]] std::vector<StepResponse> step_responses(const Model& model,
                                                       const record::Record& record);

}  // namespace raceway::correction
