#pragma once

#include <vector>

#include "correction/model.h"
#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Returns doubts about the units of a record over time.
///
/// Time:          steps of more than two hours look like ms, us or ns. A record that is shorter
///                than a time constant of `models` looks like minutes, hours or days under two
///                conditions: in this unit the record is longer than the time constant, and the
///                lags of the model explain the readings much better.
/// Temperatures:  values between 220 and 470 C look like kelvin. Values look like Fahrenheit if no
///                sensor was ever colder than 59 C, or a sensor of the surroundings never colder
///                than 50 C. A single sensor looks like Fahrenheit if its coldest reading,
///                converted from Fahrenheit, nearly equals the coldest reading of all sensors.
/// Displacements: less than 0.02 or more than 300 um for each kelvin of the largest temperature
///                change look like mm, m or nm (angles: arcsec, mrad, deg or rad), if they are 0.05
///                to 100 um (urad) per kelvin in this unit.
[[nodiscard]] std::vector<Doubt> series_doubts(const record::Record& data,
                                               const std::vector<correction::Model>& models);

/// Returns doubts about the units of a record of a spindle. In addition to the doubts above, the
/// time or the speed may be in another unit, if the simulation explains the readings only in that
/// unit. The time may be in min, h or d if the record is shorter than 4 hours, and in ms if it is
/// longer than 10 days. The speed may be in 1/s, rad/s or krpm if it stays below n d_m = 3e5
/// mm/min.
[[nodiscard]] std::vector<Doubt> series_doubts(const record::Record& data,
                                               const model::ModelSubject& spindle);

}  // namespace raceway::files
