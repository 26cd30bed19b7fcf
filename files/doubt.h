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
  /// Possible unit of a column.
  struct Guess {
    const record::Channel* channel;
    std::string_view unit;  ///< possible unit as written in files: "kgf"
  };
  std::string text;
  std::vector<Guess> units{};  ///< possible units; empty if the question is not about a unit
  /// Column whose values certainly have the opposite sign; null if the question is not about this.
  const record::Channel* reversed = nullptr;
};

/// Returns the question whether a temperature column is in `unit`, "K" or "F". `from` and `to` are
/// the lowest and highest value of the column, as they were read [C].
[[nodiscard]] Doubt other_temperature(const record::Channel& channel, double from, double to,
                                      std::string_view unit);

/// Returns the record that results if the column of `channel` is read in `unit`.
[[nodiscard]] record::Record in_other_unit(record::Record data, const record::Channel& channel,
                                           const text::Unit& unit);

/// Throws InputError if a question is about the unit or the sign of a column in the file `source`,
/// and the user has not stated the unit or a factor in the table [columns]. The message contains
/// each such question and the line of [columns] that answers it. Returns all other questions as
/// notes.
[[nodiscard]] std::vector<record::Note> asked_about(const std::vector<Doubt>& doubts,
                                                    const Source& source,
                                                    const ReadOptions& options);

}  // namespace raceway::files
