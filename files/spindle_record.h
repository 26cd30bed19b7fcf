#pragma once

#include "files/column_map.h"
#include "files/source.h"
#include "model/spindle.h"
#include "record/record.h"

namespace raceway::files {

/// Reads operating conditions and measurements of a spindle over time into SI: time_s or dates,
/// speed_rpm, the inputs of record::spindle_channel(), the sensors of the model and
/// axial_displacement_um. Other columns are not used in calculations, and a note lists them.
///
/// An empty cell of a measured column means that there is no reading. Inputs are filled between
/// their readings, as in read_series(). Throws the same exceptions as read_series(). Also throws
/// for a column whose name looks like a misspelt sensor, for a load that the model cannot carry,
/// and if a heat formula of the model needs a column that is missing.
[[nodiscard]] record::Record read_spindle_record(const Source& source,
                                                 const model::Spindle& spindle,
                                                 const ReadOptions& options = {});

/// Returns the options with `over_time` and `of_spindle` set, as read_spindle_record() needs them.
[[nodiscard]] ReadOptions of_spindle(ReadOptions options);

}  // namespace raceway::files
