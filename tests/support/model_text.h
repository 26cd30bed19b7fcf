#pragma once

#include <string>

namespace raceway::tests {

/// A model file (docs/files.md) without the catalogue, as short as it may be.
inline const std::string model_text = R"([bearing]
name = "7014"
ball_count = 20
ball_diameter_mm = 11.906
pitch_diameter_mm = 90.0
contact_angle_deg = 25.0
inner_conformity = 0.52
outer_conformity = 0.52
static_load_rating_N = 43000

[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8

[friction]
f0 = 1.5
z = 0.001
y = 0.33
)";

}  // namespace raceway::tests
