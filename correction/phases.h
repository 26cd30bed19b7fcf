#pragma once

#include <string>
#include <vector>

#include "record/record.h"

namespace raceway::correction {

/// State of a machine before a row, to show where a model fails.
inline constexpr record::Channel phase{
    .name = "phase", .variable = "phase", .words = "phase", .role = record::Role::run};

/// Phase of each row: "after a change of speed" (15 min); "rising" and "falling" where the
/// displacement changed by more than 5 % of its span in the last half hour; else "at rest" or
/// "steady".
[[nodiscard]] std::vector<std::string> phases(const record::Record& record,
                                              const record::Channel& displacement);

}  // namespace raceway::correction
