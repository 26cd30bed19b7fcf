#pragma once

#include <vector>

#include "correction/model.h"
#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Returns questions to the user about columns of a time record that may be in another unit.
///
/// Time:          a median time step above two hours suggests that the times are in ms, us or ns. A
///                record that is shorter than the longest time constant of a model may be in min, h
///                or d. The function asks about one of these units if two conditions are met. With
///                times in this unit, the record is at least as long as the time constant. The lags
///                of the model then explain the readings much better than with times in s.
/// Temperatures:  readings that are all between 220 and 470 C suggest kelvin. Readings below 220 C
///                suggest Fahrenheit if no sensor ever reads less than 59 C (59 F is 15 C), or if
///                all readings of an ambient sensor are above 50 C. The readings of a single sensor
///                that are all above 45 C suggest Fahrenheit if the lowest of them, converted from
///                Fahrenheit, is within 1.5 K of the lowest reading of the coldest sensor.
/// Displacements: the test divides the range of a displacement by the range of the temperature that
///                varies most. A ratio below 0.02 um/K or above 300 um/K suggests that the
///                displacement is in mm, m or nm. The function suggests only a unit in which the
///                ratio is from 0.05 to 100 um/K. For angles, the limits are the same in urad/K,
///                and the suggested units are arcsec, mrad, deg and rad. Displacements are not
///                tested if the temperature range is 2 K or less, or if there is already a question
///                about time or temperature.
[[nodiscard]] std::vector<Doubt> series_doubts(const record::Record& data,
                                               const std::vector<correction::Model>& models);

/// Returns questions about units for a time record of a spindle. If the tests of the overload above
/// lead to no question, the function simulates the record with the time or the speed in another
/// unit. The function asks about this unit if the simulation agrees with the readings much better
/// than in the unit of the record. The units tried for the time are min, h and d for a record
/// shorter than 4 hours, and ms for a record longer than 10 days. The units tried for the speed are
/// 1/s, rad/s and krpm, if n d_m is below 3e5 mm/min in the whole record (n: speed, d_m: pitch
/// diameter).
[[nodiscard]] std::vector<Doubt> series_doubts(const record::Record& data,
                                               const model::ModelSubject& spindle);

}  // namespace raceway::files
