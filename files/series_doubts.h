#pragma once

#include <vector>

#include "correction/model.h"
#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Doubts about the units of a record over time.
///
/// - Time: rows that come every two hours or more look like ms, us or ns. A record that is shorter
///   than a time constant of `models` looks like minutes, hours or days, where it would be longer
///   than that in them, and the lags of the model then explain the readings, which they do not as
///   it stands.
/// - Temperatures between 220 and 470 C look like kelvin. They look like Fahrenheit where no sensor
///   of the record has ever been colder than 59 C, or where the surroundings have not; one sensor
///   does where its coldest reading would then equal the coldest reading of all sensors.
/// - Displacements of less than 0.02 or more than 300 um per kelvin look like mm or nm. Machines
///   have 0.1 to 50 um/K.
[[nodiscard]] std::vector<Doubt> series_doubts(const record::Record& data,
                                               const std::vector<correction::Model>& models);

/// As above, for a record of a spindle. Where it lasts for less than 4 hours, or more than 10 days,
/// its time looks like min, h, d or ms where the simulation explains the readings in that unit
/// alone; so do its speeds like 1/s, rad/s or krpm where they stay below n d_m = 3e5 mm/min.
[[nodiscard]] std::vector<Doubt> series_doubts(const record::Record& data,
                                               const model::ModelSubject& spindle);

}  // namespace raceway::files
