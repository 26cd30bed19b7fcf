#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/range.h"
#include "correction/series.h"
#include "files/correction_file.h"
#include "record/record.h"
#include "session/messages.h"
#include "session/open_input.h"
#include "session/reading.h"
#include "session/source.h"

namespace raceway::session {

/// Reads a file of corrections, counts the defaults that were used, and says what is to be known of
/// it. Throws text::InputError as its reader, in a word for a model that has no correction.
[[nodiscard]] files::CorrectionFile open_corrections(Messages& messages, const Source& file,
                                                     Defaults defaults = Defaults::count);

/// The sum of corrections of one displacement as a file at `path`: see files::join_corrections().
/// Says what it does not have.
[[nodiscard]] files::CorrectionFile join(Messages& messages, const std::vector<Source>& parts,
                                         const std::string& path);

/// Reads a record over time for all of these models, of which only readings of that period count,
/// and says what is to be known of it. Readings that leave and return take no part, unless they
/// come `one_by_one`: nobody knows then whether one returns.
[[nodiscard]] record::Record open_series(Messages& messages, const Source& data,
                                         const std::vector<correction::Model>& models,
                                         const files::ReadOptions& options,
                                         const Period& period = {}, bool one_by_one = false);

/// All models of a file with one record.
struct SeriesQuestion {
  files::CorrectionFile file{};
  record::Record data{};
};
/// Throws text::InputError as open_corrections() and open_series().
[[nodiscard]] SeriesQuestion ask_series(Messages& messages, const Source& model, const Source& data,
                                        const Reading& reading,
                                        Defaults defaults = Defaults::count);

/// Throws text::InputError for a record without a column of the displacement.
void require_readings(const correction::Model& model, const record::Record& record);

/// Looks at a record before a model is fitted to it. Warns of sensors on which the model rests and
/// that stick, leap or never vary; into the notes of the record, too, for who reads results as
/// JSON. Throws text::InputError where a power leaves the range of a delay element.
void prepare_fit(Messages& messages, const correction::Model& model, const std::string& source,
                 record::Record& record);

/// What a record asks of a model that it was not asked when its numbers were found, in words:
/// inputs beyond their range, all of them where they never were together, power beyond the friction
/// table, from when on, and how often.
[[nodiscard]] std::vector<std::string> range_notes(const correction::Model& model,
                                                   const correction::Series& series,
                                                   const correction::Beyond& beyond);
[[nodiscard]] std::vector<std::string> range_notes(const correction::Model& model,
                                                   const record::Record& record);

}  // namespace raceway::session
