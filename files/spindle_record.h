#pragma once

#include "files/column_map.h"
#include "files/source.h"
#include "model/spindle.h"
#include "record/record.h"

namespace raceway::files {

/// What a spindle ran under and what was read of it, over time, into SI: time_s or dates,
/// speed_rpm, the inputs that record::spindle_channel() knows, and of what is measured the sensors
/// of the model and axial_displacement_um. Columns of other names are named and ignored.
///
/// An empty cell of what is measured was not read then; everywhere else it is an error. Throws as
/// read_series(), and for a column that is a misspelt sensor.
[[nodiscard]] record::Record read_spindle_record(const Source& source,
                                                 const model::Spindle& spindle,
                                                 const ReadOptions& options = {});

/// Of columns as read_spindle_record() has them.
[[nodiscard]] ReadOptions of_spindle(ReadOptions options);

}  // namespace raceway::files
