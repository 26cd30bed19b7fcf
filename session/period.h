#pragma once

#include <string>
#include <vector>

#include "record/record.h"

namespace raceway::session {

/// `--from 20h` and `--until 24h`: the readings of a record over time that count. All rows drive
/// the model, whichever count.
struct Period {
  std::string from, until;

  [[nodiscard]] bool is_given() const { return !from.empty() || !until.empty(); }
  /// Takes readings of these displacements out that are outside, and notes how many are left.
  /// Throws text::InputError: no time, none left.
  void apply(record::Record& record, const std::vector<const record::Channel*>& measured) const;
};

}  // namespace raceway::session
