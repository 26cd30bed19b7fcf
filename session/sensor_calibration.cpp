#include "session/sensor_calibration.h"

#include <stdexcept>

#include "files/sensor_file.h"
#include "text/error.h"

namespace raceway::session {

std::string CalibratedSensor::json() const {
  return files::sensor_calibration_json(calibration, source);
}

std::string CalibratedSensor::text() const {
  return files::torque_sensor_text(calibration, source);
}

CalibratedSensor calibrate_sensor(Messages& messages, const Source& readings,
                                  const Reading& reading, std::optional<int> degree) {
  const files::SensorReadings read = files::read_sensor_readings(readings, reading.options());
  messages.say(read.notes);
  try {
    CalibratedSensor result{.source = read.source,
                            .calibration = rig::calibrate_sensor(read.readings, degree)};
    messages.say(result.calibration.notes);
    messages.say(result.calibration.warnings);
    return result;
  } catch (const std::invalid_argument& e) {
    throw text::InputError(read.source + ": " + e.what(), {.file = read.source});
  }
}

}  // namespace raceway::session
