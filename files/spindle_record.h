#pragma once

#include "files/column_map.h"
#include "files/source.h"
#include "model/spindle.h"
#include "record/record.h"

namespace raceway::files {

/// Reads operating conditions and measurements of a spindle over time into SI: time_s or dates,
/// speed_rpm, the inputs that record::spindle_channel() knows, the sensors of the model and
/// axial_displacement_um. Other columns are named in a note and ignored.
///
/// An empty cell of a measured column means that there is no reading. An empty cell in any other
/// column is an error. Throws like read_series(), and for a column whose name looks like a misspelt
/// sensor.
[[nodiscard]] record::Record read_spindle_record(const Source& source,
                                                 const model::Spindle& spindle,
                                                 const ReadOptions& options = {});

/// Returns the options for the columns of read_spindle_record().
[[nodiscard]] ReadOptions of_spindle(ReadOptions options);

}  // namespace raceway::files
