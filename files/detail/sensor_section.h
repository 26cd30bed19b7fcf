#pragma once

#include <optional>
#include <vector>

#include "rig/sensor_calibration.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the table [torque_sensor] of a model file, or of a separate file that the model names.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> torque_sensor_tables();

/// Returns the calibration of the torque sensor; nothing if the model has none. Throws InputError
/// like read_model().
[[nodiscard]] std::optional<rig::TorqueSensor> read_torque_sensor(ModelTables& tables);

}  // namespace raceway::files
