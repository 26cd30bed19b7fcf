#pragma once

#include <string>

#include "files/column_map.h"
#include "files/source.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Reads a CSV file of measurements into SI. docs/files.md lists the columns with their units.
///
/// Loads and temperature may come from the model, and so may the inertia that converts a coast-down
/// (a record of only time and speed) to friction torque: see Expected. The reader keeps the
/// measured columns that `subject` predicts. If the file has none of these columns, the reader
/// keeps the first column of Expected::measured, which the subject may then reject. `notes` lists
/// everything that was filled in, ignored or omitted.
///
/// An empty cell is an error, with one exception: if the file has several measured columns, an
/// empty cell in one of them means that there is no reading.
///
/// Throws InputError if a required column is missing, if there is no measured column, if a column
/// name looks misspelt, if a coast-down gives no torque, and for every cell that is empty, not a
/// number or impossible. One message shows the first ten of these cells and counts the others.
[[nodiscard]] record::Record read_record(const Source& source, const model::ModelSubject& subject,
                                         const ReadOptions& options = {});

}  // namespace raceway::files
