#pragma once

#include <string>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// Phase of operation in each row. Errors grouped by phase show in which phase a model fails.
inline constexpr record::Channel phase{
    .name = "phase", .variable = "phase", .words = "phase", .role = record::Role::run};

/// Returns the phase of each row. The phase is "after a change of speed" for 15 min after each
/// change. Otherwise the phase is "rising" or "falling" if the displacement has changed by more
/// than 5 % of its range in the last half hour. Otherwise the phase is "at rest" at speed 0, and
/// "steady" at other speeds. All texts are empty if the record has no time or no displacement.
[[nodiscard]] std::vector<std::string> phases(const record::Record& record,
                                              const record::Channel& displacement);

}  // namespace raceway::correction
