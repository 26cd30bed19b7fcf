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

/// A question about the contents of a record.
struct Doubt {
  /// A column that may be in a different unit.
  struct Guess {
    const record::Channel* channel;
    std::string_view unit;  ///< as written in files: "kgf"
  };
  std::string text;
  std::vector<Guess> units{};  ///< empty if the question is not about a unit
};

/// Returns the question about a temperature channel whose values look like another unit, "K" or
/// "F". `from` and `to` are the range of the values as they were read [C].
[[nodiscard]] Doubt other_temperature(const record::Channel& channel, double from, double to,
                                      std::string_view unit);

/// Returns the record with a channel in a different unit.
[[nodiscard]] record::Record in_other_unit(record::Record data, const record::Channel& channel,
                                           const text::Unit& unit);

/// Throws InputError if [columns] does not settle a doubt about the unit of a column of `source`.
/// The message contains each question and the line of [columns] that answers it. All other doubts
/// are returned as notes.
[[nodiscard]] std::vector<record::Note> asked_about(const std::vector<Doubt>& doubts,
                                                    const Source& source,
                                                    const ReadOptions& options);

}  // namespace raceway::files
