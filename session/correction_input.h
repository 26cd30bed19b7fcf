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

/// Reads a file of corrections, counts the defaults that were used, and gives notes on it. Throws
/// text::InputError as its reader, and with a short message for a model that has no correction.
[[nodiscard]] files::CorrectionFile open_corrections(Messages& messages, const Source& file,
                                                     Defaults defaults = Defaults::count);

/// The sum of corrections of one displacement as a file at `path`: see files::join_corrections().
/// Notes list the parts that it leaves out.
[[nodiscard]] files::CorrectionFile join(Messages& messages, const std::vector<Source>& parts,
                                         const std::string& path);

/// Reads a record over time for all of these models and adds notes on it. Only readings of that
/// period count. Readings that leave and return take no part, unless they come `one_by_one`: the
/// return of a reading is then unknown.
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

/// Checks a record before a model is fitted to it. Warns of sensors of the model that stick, leap
/// or never vary, also in the notes of the record, for readers of the JSON results. Throws
/// text::InputError where a power leaves the range of a delay element.
void prepare_fit(Messages& messages, const correction::Model& model, const std::string& source,
                 record::Record& record);

/// Notes on extrapolation of a model by a record: inputs beyond their range, combinations of inputs
/// outside the joint range, power beyond the friction table, each with its start and number of
/// rows.
[[nodiscard]] std::vector<std::string> range_notes(const correction::Model& model,
                                                   const correction::Series& series,
                                                   const correction::Beyond& beyond);
[[nodiscard]] std::vector<std::string> range_notes(const correction::Model& model,
                                                   const record::Record& record);

}  // namespace raceway::session
