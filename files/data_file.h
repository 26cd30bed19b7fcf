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
/// Loads and temperature may come from the model, and so may the inertia that converts a coast-down
/// (a record of only time and speed) to friction torque: see Expected. The reader keeps the
/// measured columns that the subject predicts. If there are none, it keeps the first column of
/// Expected::measured, and the subject may then reject it. `notes` lists everything that was filled
/// in, ignored or omitted.
///
/// An empty cell is an error. If the file has several measured columns, an empty cell in one of
/// them means that there is no reading.
///
/// Throws InputError if a required column is missing, if there is no measured column, if a column
/// name looks misspelt, if a coast-down gives no torque, and for every cell that is empty, not a
/// number or impossible. One message lists all these cells, the first ten in full.
[[nodiscard]] record::Record read_record(const Source& source, const model::ModelSubject& subject,
                                         const ReadOptions& options = {});

}  // namespace raceway::files
