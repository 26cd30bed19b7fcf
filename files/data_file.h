#pragma once

#include <string>

#include "files/column_map.h"
#include "files/source.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Reads a CSV file of measurements and converts it to SI. docs/files.md lists the columns with
/// their units.
///
/// If the file has no columns of loads or temperature, the values of the model are used. For a
/// coast-down (a record of only time and speed, or of the times between two speeds), the reader
/// calculates the friction torque with the inertia of the model. If the inertia is unknown, the
/// reader assumes a value with which the mean torque equals the mean torque of the model. The
/// reader keeps the measured columns that `subject` predicts. If the file has none of these
/// columns, the reader keeps the first column of model::Expected::measured, which `subject` may
/// reject. `notes` of the record list everything that was filled in, ignored or omitted.
///
/// An empty cell is an error, with three exceptions. If the record keeps several measured columns,
/// an empty cell in one of them is a missing reading. Empty cells of measured columns that are not
/// kept have no influence. With `options.drop_nan`, rows with empty cells are omitted.
///
/// Throws InputError if a required column is missing, if there is no measured column, if a column
/// name looks misspelt, if a coast-down gives no torque, and for cells that are empty (with the
/// exceptions above), not numbers or outside the allowed range. One message shows the first ten
/// invalid cells and counts the others.
[[nodiscard]] record::Record read_record(const Source& source, const model::ModelSubject& subject,
                                         const ReadOptions& options = {});

}  // namespace raceway::files
