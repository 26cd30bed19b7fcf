#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/csv.h"
#include "model/model_subject.h"

/// The header of a measurement file; shared with the reader of records, not for other code.
namespace raceway::io {

/// Which columns of a file hold which channels.
struct DataColumns {
  struct Place {
    const record::Channel* channel;
    std::size_t column;  ///< of the file
  };
  std::vector<Place> places;  ///< in the order of the table of channels
  /// Measured channels that are kept, and those that are not. Both are empty for a coast-down.
  std::vector<const record::Channel*> measured, unused;
  std::vector<std::string> notes;  ///< on columns that nobody knows

  /// Null where the file has no such column.
  [[nodiscard]] const Place* find(const record::Channel& channel) const;
  [[nodiscard]] bool coast_down() const { return measured.empty(); }
  /// False for a measured channel that is not kept, and for its deviation.
  [[nodiscard]] bool keeps(const record::Channel& channel) const;
};

/// Throws InputError for a column that looks misspelt and for one that is missing.
[[nodiscard]] DataColumns find_columns(const CsvTable& table, const model::ModelSubject& subject,
                                       const model::Expected& expected);

}  // namespace raceway::io
