#pragma once

#include <optional>
#include <vector>

#include "rig/sensor_calibration.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// [torque_sensor] of a model file, or of a file of its own that it names; shared with the reader
/// of models.
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> torque_sensor_tables();

/// Nothing if the model names none. Throws InputError as read_model().
[[nodiscard]] std::optional<rig::TorqueSensor> read_torque_sensor(ModelTables& tables);

}  // namespace raceway::files
