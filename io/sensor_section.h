#pragma once

#include <optional>
#include <vector>

#include "rig/sensor_calibration.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

/// [torque_sensor] of a model file, or of a file of its own that it names; shared with the reader
/// of models, not for other code.
namespace raceway::io {

[[nodiscard]] std::vector<KeyTable> torque_sensor_tables();

/// Nothing where the model says none. Throws InputError as read_model().
[[nodiscard]] std::optional<rig::TorqueSensor> read_torque_sensor(ModelTables& tables);

}  // namespace raceway::io
