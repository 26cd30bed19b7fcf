#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/column_map.h"
#include "files/source.h"
#include "record/note.h"
#include "rig/sensor_calibration.h"

/// Reads the calibration readings of a torque sensor, and writes the calibration.
namespace raceway::files {

/// Calibration readings of a torque sensor in the order of the file.
struct SensorReadings {
  std::string source;  ///< file name, for messages
  std::vector<rig::SensorReading> readings = {};
  std::vector<record::Note> notes = {};  ///< notes for the user
};

/// Reads the columns `reference_Nm` and `signal_V` from a CSV file; "-" is standard input. The
/// signal may also be in a column `torque_signal_V`, as in a record. Other columns are ignored, and
/// `notes` lists them. Throws InputError if read_csv() cannot read the file, if a column is
/// missing, or if a cell is empty, not a number or outside the allowed range.
[[nodiscard]] SensorReadings read_sensor_readings(const Source& source,
                                                  const ReadOptions& options = {});

/// Returns the text of the table [torque_sensor] for a model file or a separate file.
[[nodiscard]] std::string torque_sensor_text(const rig::SensorCalibration& calibration,
                                             std::string_view source);

/// Returns the unit of a coefficient of the calibration polynomial: "V" for coefficient 0, "V/Nm"
/// for 1, "V/Nm2" for 2, and "V/Nm3" for 3.
[[nodiscard]] std::string coefficient_unit(int coefficient);

/// Returns the calibration as a JSON document (docs/files.md).
[[nodiscard]] std::string sensor_calibration_json(const rig::SensorCalibration& calibration,
                                                  const std::string& source);

}  // namespace raceway::files
