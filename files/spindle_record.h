#pragma once

#include "files/column_map.h"
#include "files/source.h"
#include "model/spindle.h"
#include "record/record.h"

namespace raceway::files {

/// Reads a time record of a spindle and converts these columns to SI: time_s or dates, speed_rpm,
/// the input columns in the list of record::spindle_channel(), the temperatures of the sensors in
/// the model, and axial_displacement_um. Other columns are not used in calculations, and a note
/// lists them.
///
/// An empty cell of a measured column is a missing reading. Empty cells of an input are filled as
/// in read_series(). Throws InputError in the same cases as read_series(), and in these cases:
///   - The record has a load that the model cannot use.
///   - A heat formula of the model contains motor_power_W, and the record lacks this column.
///   - A column name looks like the misspelt name of a sensor.
[[nodiscard]] record::Record read_spindle_record(const Source& source,
                                                 const model::Spindle& spindle,
                                                 const ReadOptions& options = {});

/// Returns a copy of the options in which `over_time` and `of_spindle` are true, as
/// read_spindle_record() requires.
[[nodiscard]] ReadOptions of_spindle(ReadOptions options);

}  // namespace raceway::files
