#pragma once

#include <string>

#include "files/column_map.h"
#include "files/source.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Reads a measurement CSV (columns with their units: docs/files.md) into SI, by the table of
/// channels.
///
/// What the file may leave out comes from the model, as Expected says: loads, temperature, and the
/// inertia by which a coast-down (time and speed alone) becomes friction torque. Of the measured
/// columns those are kept that the subject predicts; where there is none of them the first one of
/// Expected::measured, which the subject may then refuse. Whatever was filled in, ignored or left
/// out is told in `notes`.
///
/// An empty cell is an error, but in a measured column beside others: it was not read then.
///
/// Throws InputError: a required or no measured column missing, a column that looks misspelt, every
/// cell that is empty, no number or impossible (all of them in one message, the first ten in full),
/// and a coast-down that gives no torque.
[[nodiscard]] record::Record read_record(const Source& source, const model::ModelSubject& subject,
                                         const ReadOptions& options = {});

}  // namespace raceway::files
