#pragma once

#include <string>
#include <vector>

#include "control/plan.h"
#include "correction/model.h"
#include "record/record.h"

/// Makes the check record for an exported program. A check record contains rows of inputs and the
/// displacements that `correct` predicts for these rows.
namespace raceway::control {

/// Returns a check record from the first run of a measured record, with at most `most_rows` rows.
///
/// Inputs are limited to the ranges of the models, because outside these ranges the exported
/// program intentionally differs from `correct`. The check record ends before the first row in
/// which a power is outside its range or a model has no result. It is empty if fewer than two rows
/// remain.
[[nodiscard]] ControlCheck check_of(const ControlPlan& plan,
                                    const std::vector<correction::Model>& models,
                                    const record::Record& record, std::size_t most_rows = 1000);

/// Returns a synthetic check record within the ranges of the models: varying temperatures, blocks
/// of speeds and feeds, and a coolant that switches on and off. The record has at most 60 rows.
/// Without transfer functions, it lasts about twice the longest time constant of the sections, at
/// least 20 min, and has a gap in time. If a model has a transfer function, the time step is the
/// sampling interval of this function, and there is no gap.
[[nodiscard]] ControlCheck made_up_check(const ControlPlan& plan,
                                         const std::vector<correction::Model>& models);

/// Returns one sentence for each temperature sensor and axis for which one resolution step of the
/// sensor immediately moves the axis by 0.5 um (urad) or more. Sensors with smoothing are not
/// checked.
[[nodiscard]] std::vector<std::string> coarse_sensors(const ControlPlan& plan,
                                                      const record::Record& record);

/// Calls allow_to_stand() for every input of the plan, with the longest time for which the input is
/// constant in the record. Returns one sentence for each changed input.
[[nodiscard]] std::vector<std::string> allow_still_sensors(ControlPlan& plan,
                                                           const record::Record& record);

}  // namespace raceway::control
