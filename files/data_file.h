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
/// Loads, temperature and the inertia that turns a coast-down (time and speed alone) into friction
/// torque may come from the model, as Expected says. The reader keeps the measured columns that the
/// subject predicts. If there are none, it keeps the first of Expected::measured, which the subject
/// may then refuse. `notes` lists everything that was filled in, ignored or left out.
///
/// An empty cell is an error, except in a measured column with others: it counts as not read.
///
/// Throws InputError: a required or no measured column missing, a column that looks misspelt, every
/// cell that is empty, no number or impossible (all of them in one message, the first ten in full),
/// and a coast-down that gives no torque.
[[nodiscard]] record::Record read_record(const Source& source, const model::ModelSubject& subject,
                                         const ReadOptions& options = {});

}  // namespace raceway::files
