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

/// Reads a file of corrections and sends notes to `messages`. If `defaults` is Defaults::count, one
/// of the notes gives the number of default values that the corrections use. Throws
/// text::InputError for a file that cannot be read.
[[nodiscard]] files::CorrectionFile open_corrections(Messages& messages, const Source& file,
                                                     Defaults defaults = Defaults::count);

/// Joins several corrections of one displacement to one file with the name `path`. The joined file
/// predicts the sum of all these corrections: see files::join_corrections(). If several of the
/// files contain a table such as [columns], the joined file contains the table of the first of
/// these files. A note names each table that is not used.
[[nodiscard]] files::CorrectionFile join(Messages& messages, const std::vector<Source>& parts,
                                         const std::string& path);

/// Reads a time record for all `models` and sends notes to `messages`. Only readings within
/// `period` are used. Isolated readings are removed. An isolated reading is far from the readings
/// before and after it. If `one_by_one` is true, the readings are used one after the other, as in
/// learning. Isolated readings are then kept, because the next reading is not known.
[[nodiscard]] record::Record open_series(Messages& messages, const Source& data,
                                         const std::vector<correction::Model>& models,
                                         const files::ReadOptions& options,
                                         const Period& period = {}, bool one_by_one = false);

/// All corrections of a file, and one record.
struct SeriesQuestion {
  files::CorrectionFile file{};
  record::Record data{};
};
/// Opens the file of corrections and the record. Throws the same exceptions as open_corrections()
/// and open_series().
[[nodiscard]] SeriesQuestion ask_series(Messages& messages, const Source& model, const Source& data,
                                        const Reading& reading,
                                        Defaults defaults = Defaults::count);

/// Throws text::InputError if the record has no column with the displacement that the model
/// predicts.
void require_readings(const correction::Model& model, const record::Record& record);

/// Returns the note that the start state of a warm machine (initial_state = "free") is fitted to
/// the readings of the record; empty if the model starts from rest.
[[nodiscard]] std::vector<std::string> fitted_start(const correction::Model& model);

/// Checks a record before a model is fitted to it. Warns of input sensors whose readings jump, or
/// do not vary in a part of the record or in the whole record. The warnings are also in the notes
/// of the record and in the JSON results. Throws text::InputError if an input, such as the heating
/// power, has a value at which the time constant of a lag is not positive.
void prepare_fit(Messages& messages, const correction::Model& model, const std::string& source,
                 record::Record& record);

/// Returns notes on extrapolation in a record: inputs outside their range in the training data,
/// combinations of inputs outside the training data, and operating points outside the friction
/// table. A note on inputs gives the first row outside the training data and the number of such
/// rows. A note on a friction table gives the percentage of the rows outside the table.
[[nodiscard]] std::vector<std::string> range_notes(const correction::Model& model,
                                                   const correction::Series& series,
                                                   const correction::Beyond& beyond);
[[nodiscard]] std::vector<std::string> range_notes(const correction::Model& model,
                                                   const record::Record& record);

}  // namespace raceway::session
