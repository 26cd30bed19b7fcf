#pragma once

#include <vector>

#include "correction/model.h"
#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Returns questions to the user about columns of a time record that may be in another unit.
///
/// Time:          a median time step above two hours looks like ms, us or ns. A record that is
///                shorter than the longest time constant of a model looks like minutes, hours or
///                days under two conditions: in this unit the record is longer than the time
///                constant, and the lags of the model explain the readings much better.
/// Temperatures:  values between 220 and 470 C look like kelvin. Values below 220 C look like
///                Fahrenheit if no sensor ever reads less than 59 C, or if all readings of an
///                ambient sensor are above 50 C. A single sensor whose readings are all above 45 C
///                looks like Fahrenheit if its lowest reading, converted from Fahrenheit, is within
///                1.5 K of the lowest reading of the coldest sensor.
/// Displacements: the test divides the range of a displacement by the range of the temperature that
///                varies most. A displacement of less than 0.02 or more than 300 um/K looks like
///                mm, m or nm (an angle: arcsec, mrad, deg or rad), if it is 0.05 to 100 um/K
///                (urad/K) in this unit. Displacements are not tested if the temperature range is
///                2 K or less, or if there is already a question about time or a temperature.
[[nodiscard]] std::vector<Doubt> series_doubts(const record::Record& data,
                                               const std::vector<correction::Model>& models);

/// Returns questions about units for a time record of a spindle. If the tests above lead to no
/// question, the function simulates the record with the time or the speed in another unit. It asks
/// about this unit if the simulation explains the readings only with it. The time may be in min, h
/// or d if the record is shorter than 4 hours, and in ms if it is longer than 10 days. The speed n
/// may be in 1/s, rad/s or krpm if n d_m stays below 3e5 mm/min (d_m: pitch diameter).
[[nodiscard]] std::vector<Doubt> series_doubts(const record::Record& data,
                                               const model::ModelSubject& spindle);

}  // namespace raceway::files
