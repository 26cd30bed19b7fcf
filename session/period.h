#pragma once

#include <string>
#include <vector>

#include "record/record.h"

namespace raceway::session {

/// Period of a time record. A fit uses only the readings in this period. The inputs of all rows are
/// used, because rows before the period influence the displacement in the period. `from` and
/// `until` are times since the first row, written as text such as "20h". An empty text means no
/// limit.
struct Period {
  std::string from, until;

  [[nodiscard]] bool is_given() const { return !from.empty() || !until.empty(); }
  /// Removes the readings of the channels `measured` outside the period, and adds a note to the
  /// record with the number of remaining readings. Throws text::InputError for a text that is not a
  /// duration, and if no reading remains.
  void apply(record::Record& record, const std::vector<const record::Channel*>& measured) const;
};

}  // namespace raceway::session
