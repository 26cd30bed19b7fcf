#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/channel.h"
#include "record/note.h"
#include "record/record.h"
#include "text/units.h"

namespace raceway::files {

/// A question to the user about a possible fault of a record, such as a wrong unit.
struct Doubt {
  /// A quantity whose column may be in a different unit.
  struct Guess {
    const record::Channel* channel;
    std::string_view unit;  ///< other unit as written in files: "kgf"
  };
  std::string text;
  std::vector<Guess> units{};  ///< possible units; empty if the question is not about a unit
};

/// Returns the question whether a temperature column is in `unit`, "K" or "F". `from` and `to` are
/// the limits of its values as they were read [C].
[[nodiscard]] Doubt other_temperature(const record::Channel& channel, double from, double to,
                                      std::string_view unit);

/// Returns the record with the values of a channel read in a different unit.
[[nodiscard]] record::Record in_other_unit(record::Record data, const record::Channel& channel,
                                           const text::Unit& unit);

/// Throws InputError for questions about the unit of a column of `source`, unless [columns] states
/// this unit. The message contains each question and the line of [columns] that answers it. All
/// other questions are returned as notes.
[[nodiscard]] std::vector<record::Note> asked_about(const std::vector<Doubt>& doubts,
                                                    const Source& source,
                                                    const ReadOptions& options);

}  // namespace raceway::files
