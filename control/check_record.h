#pragma once

#include <string>
#include <vector>

#include "control/plan.h"
#include "correction/model.h"
#include "record/record.h"

/// Check record for the program of a plan: rows of a record and the result of `correct` for them.
namespace raceway::control {

/// Returns a check record from a measured record: its first run, at most `most_rows` rows.
///
/// Inputs are limited to the ranges of the models, because a control deliberately deviates beyond
/// them. The check ends where a power leaves its range. It has no rows if fewer than two remain.
[[nodiscard]] ControlCheck check_of(const ControlPlan& plan,
                                    const std::vector<correction::Model>& models,
                                    const record::Record& record, std::size_t most_rows = 1000);

/// Returns a synthetic check record within the ranges: warming up, cooling down, speeds and feeds
/// in blocks, a coolant that switches and a gap, long enough for the slowest section.
[[nodiscard]] ControlCheck made_up_check(const ControlPlan& plan,
                                         const std::vector<correction::Model>& models);

/// Returns one sentence for each sensor whose last digit in the record moves an axis at once by
/// half a micrometre or more, without smoothing.
[[nodiscard]] std::vector<std::string> coarse_sensors(const ControlPlan& plan,
                                                      const record::Record& record);

/// Applies allow_to_stand() to every sensor of a record; returns one sentence for each change.
[[nodiscard]] std::vector<std::string> allow_still_sensors(ControlPlan& plan,
                                                           const record::Record& record);

}  // namespace raceway::control
