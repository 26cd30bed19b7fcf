#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"
#include "rig/sensor_calibration.h"

/// Calibration of a torque sensor: readings and result.
namespace raceway::files {

/// Readings in the order of the file.
struct SensorReadings {
  std::string source;  ///< file name, for messages
  std::vector<rig::SensorReading> readings = {};
  std::vector<record::Note> notes = {};  ///< notes for the user
};

/// Reads `reference_Nm` and `signal_V` from a CSV; "-" is standard input. The signal may also be
/// `torque_signal_V`, as in a record. Other columns are not read, and `notes` lists them. Throws
/// InputError like read_csv(), for a missing column, and for every cell that is empty, not a number
/// or impossible.
[[nodiscard]] SensorReadings read_sensor_readings(const Source& source,
                                                  const ReadOptions& options = {});

/// Returns the table [torque_sensor] for a model or a separate file. parse_model() can read this
/// table.
[[nodiscard]] std::string torque_sensor_text(const rig::SensorCalibration& calibration,
                                             std::string_view source);

/// Returns the unit of a coefficient: "V", "V/Nm", "V/Nm2", "V/Nm3".
[[nodiscard]] std::string coefficient_unit(int coefficient);

/// Returns the calibration as a JSON document (docs/files.md).
[[nodiscard]] std::string sensor_calibration_json(const rig::SensorCalibration& calibration,
                                                  const std::string& source);

}  // namespace raceway::files
