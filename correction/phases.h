#pragma once

#include <string>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// State of the machine in each row. Errors grouped by this state show where a model fails.
inline constexpr record::Channel phase{
    .name = "phase", .variable = "phase", .words = "phase", .role = record::Role::run};

/// Returns the phase of each row: "after a change of speed" (for 15 min); "rising" or "falling" if
/// the displacement changed by more than 5 % of its span in the last half hour; otherwise "at rest"
/// at speed 0, or "steady".
[[nodiscard]] std::vector<std::string> phases(const record::Record& record,
                                              const record::Channel& displacement);

}  // namespace raceway::correction
