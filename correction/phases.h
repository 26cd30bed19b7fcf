#pragma once

#include <string>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// Phase of operation in each row. Errors grouped by phase show where a model fails.
inline constexpr record::Channel phase{
    .name = "phase", .variable = "phase", .words = "phase", .role = record::Role::run};

/// Returns the phase of each row: "after a change of speed" for 15 min; then "rising" or "falling"
/// if the displacement has changed by more than 5 % of its range in the last half hour; otherwise
/// "at rest" at speed 0, or "steady". All texts are empty if the record has no time or no
/// displacement.
[[nodiscard]] std::vector<std::string> phases(const record::Record& record,
                                              const record::Channel& displacement);

}  // namespace raceway::correction
