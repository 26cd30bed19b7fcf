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
/// If the file has no column for a load or for the temperature, the value of the model is used. A
/// record without torque is a coast-down. A coast-down contains time and speed, or the times in
/// which the speed falls from one value to another. For a coast-down, the reader calculates the
/// friction torque with the inertia of the model. If the inertia is unknown, the reader assumes an
/// inertia for which the mean calculated torque equals the mean torque predicted by the model. The
/// reader keeps the measured columns for which `subject` has a prediction. If the file has no such
/// column, the reader keeps one measured column: the first in the order of
/// model::Expected::measured. `notes` of the record list all values that were filled in, ignored or
/// omitted.
///
/// If the reader keeps several measured columns, an empty cell in one of them is a missing reading.
/// Empty cells in measured columns that are not kept have no influence. Any other empty cell in a
/// used column is an error, or its row is omitted if `options.drop_nan` is true.
///
/// Throws InputError if a required column or all measured columns are missing, if a column name
/// looks misspelt, if the torque of a coast-down cannot be calculated, and for invalid cells. A
/// cell is invalid if it is not a number, is outside the allowed range, or is empty in a column
/// that needs a value in every row (see above). The message shows the first ten invalid cells and
/// gives the number of all invalid cells.
[[nodiscard]] record::Record read_record(const Source& source, const model::ModelSubject& subject,
                                         const ReadOptions& options = {});

}  // namespace raceway::files
