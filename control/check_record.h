#pragma once

#include <string>
#include <vector>

#include "control/plan.h"
#include "correction/model.h"
#include "record/record.h"

/// Makes the check record for the program of a plan. A check record has rows of a record and the
/// results of `correct` for these rows.
namespace raceway::control {

/// Returns a check record from the first run of a measured record, with at most `most_rows` rows.
///
/// Inputs are limited to the ranges of the models, because the program of a control intentionally
/// differs from `correct` outside these ranges. The check ends before the first row in which a
/// power leaves its range or a model has no result. The check record has no rows if fewer than two
/// rows remain.
[[nodiscard]] ControlCheck check_of(const ControlPlan& plan,
                                    const std::vector<correction::Model>& models,
                                    const record::Record& record, std::size_t most_rows = 1000);

/// Returns a synthetic check record within the ranges: warm-up, cool-down, blocks of speeds and
/// feeds, a coolant that switches on and off, and a gap in time. The record lasts about twice the
/// time constant of the slowest section. If a model has published coefficients, the record has 60
/// rows at their sampling interval and no gap instead.
[[nodiscard]] ControlCheck made_up_check(const ControlPlan& plan,
                                         const std::vector<correction::Model>& models);

/// Returns one sentence for each temperature sensor without smoothing and each axis, if one step of
/// the last digit of the sensor moves the axis by 0.5 um (urad) or more at once.
[[nodiscard]] std::vector<std::string> coarse_sensors(const ControlPlan& plan,
                                                      const record::Record& record);

/// Applies allow_to_stand() to every input, with the longest time for which this input is constant
/// in the record. Returns one sentence for each change.
[[nodiscard]] std::vector<std::string> allow_still_sensors(ControlPlan& plan,
                                                           const record::Record& record);

}  // namespace raceway::control
