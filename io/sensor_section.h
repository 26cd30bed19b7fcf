#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rig/sensor_calibration.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

/// [torque_sensor] of a model file, or of a file of its own that it names; shared with the reader
/// of models, not for other code.
namespace raceway::io {

struct SensorOfFile {
  std::optional<rig::TorqueSensor> sensor{};  ///< nothing where the model says none
  std::string file{};                         ///< that the model names; empty where it names none
};

/// `file` is relative to the model. Throws InputError as read_model().
[[nodiscard]] SensorOfFile read_torque_sensor(const ModelTables& tables);

}  // namespace raceway::io
