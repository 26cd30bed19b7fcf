#pragma once

#include "files/column_map.h"
#include "files/source.h"
#include "model/spindle.h"
#include "record/record.h"

namespace raceway::files {

/// Reads a time record of a spindle and converts these columns to SI: time_s or dates, speed_rpm,
/// the input columns that record::spindle_channel() knows, the sensors of the model and
/// axial_displacement_um. Other columns are not used in calculations, and a note lists them.
///
/// An empty cell of a measured column is a missing reading. Empty cells of an input are filled as
/// in read_series(). Throws InputError like read_series(), for a column whose name looks like a
/// misspelt sensor, for a load that the model cannot use, and if a heat formula of the model needs
/// a missing column.
[[nodiscard]] record::Record read_spindle_record(const Source& source,
                                                 const model::Spindle& spindle,
                                                 const ReadOptions& options = {});

/// Returns the options with `over_time` and `of_spindle` = true, as read_spindle_record() needs
/// them.
[[nodiscard]] ReadOptions of_spindle(ReadOptions options);

}  // namespace raceway::files
