#pragma once

#include <optional>
#include <string>

#include "rig/sensor_calibration.h"
#include "session/messages.h"
#include "session/reading.h"
#include "session/source.h"

namespace raceway::session {

/// Calibration of a torque sensor from readings at known torques.
struct CalibratedSensor {
  std::string source{};  ///< file with the readings, for messages
  rig::SensorCalibration calibration{};

  [[nodiscard]] std::string json() const;
  /// Returns the table [torque_sensor] for a model file or a separate file.
  [[nodiscard]] std::string text() const;
};

/// Fits a polynomial to the readings of a torque sensor. If `degree` is empty, the function uses
/// the lowest degree that fits the readings. Throws text::InputError for a file that cannot be
/// read, and for readings that do not determine the polynomial.
[[nodiscard]] CalibratedSensor calibrate_sensor(Messages& messages, const Source& readings,
                                                const Reading& reading, std::optional<int> degree);

}  // namespace raceway::session
