#pragma once

#include <string>
#include <vector>

#include "control/plan.h"
#include "correction/model.h"
#include "record/record.h"

/// Makes the check record, with which a user tests an exported program. A check record contains
/// rows of inputs and the displacements that `raceway correct` predicts for these rows.
namespace raceway::control {

/// Returns a check record from the first run of a measured record, with at most `most_rows` rows.
///
/// Inputs are limited to the ranges of the training data, because outside these ranges the results
/// of the exported program intentionally differ from the results of `raceway correct`. The check
/// record ends before the first row in which a friction power is outside the range of the training
/// data, or in which a model predicts no displacement. The check record is empty if fewer than two
/// rows remain.
[[nodiscard]] ControlCheck check_of(const ControlPlan& plan,
                                    const std::vector<correction::Model>& models,
                                    const record::Record& record, std::size_t most_rows = 1000);

/// Returns a synthetic check record within the ranges of the training data. Temperatures vary,
/// speeds and feeds change in steps, and the coolant switches on and off. The record has at most 60
/// rows. If no model has a transfer function, the record lasts about twice the longest time
/// constant of the lags (ControlSection), but at least 20 min. Without a transfer function, one
/// time step is much longer than the others, as in a record with a gap. If a model has a transfer
/// function, all time steps are equal to the sampling interval of this function.
[[nodiscard]] ControlCheck made_up_check(const ControlPlan& plan,
                                         const std::vector<correction::Model>& models);

/// Returns warnings about temperature sensors with a coarse resolution. The function warns of a
/// sensor if its smallest step (the resolution) immediately changes the correction of an axis by
/// 0.5 um (0.5 urad) or more. Sensors with smoothing are not checked.
[[nodiscard]] std::vector<std::string> coarse_sensors(const ControlPlan& plan,
                                                      const record::Record& record);

/// Adapts the limits stuck_s to a record. stuck_s is the time after which the exported program
/// reports a constant sensor as stuck. If a temperature sensor is constant for a long time in the
/// record, allow_to_stand() increases the limit of this sensor, so that the program does not report
/// the sensor as stuck. Returns one sentence for each increased limit.
[[nodiscard]] std::vector<std::string> allow_still_sensors(ControlPlan& plan,
                                                           const record::Record& record);

}  // namespace raceway::control
