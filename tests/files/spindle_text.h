#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

/// Models of a spindle for tests of its readers and its command.
namespace raceway::tests {

/// The shortest that runs.
inline const std::string shortest_spindle = R"([bearing]
catalogue = "S 6014 C"
[lubricant]
viscosity_40C_mm2_s = 20.0
viscosity_100C_mm2_s = 4.4
[arrangement]
layout = "O"
front = 2
rear = 1
mounting = "rigid"
preload_N = 300
front_position_mm = [60, 90]
rear_position_mm = [290]
[shaft]
bore_mm = 36
segment = [{length_mm = 50, diameter_mm = 104}, {length_mm = 50, diameter_mm = 70},
           {length_mm = 180, diameter_mm = 82}, {length_mm = 20, diameter_mm = 70},
           {length_mm = 75, diameter_mm = 60}]
[housing]
start_mm = 40
length_mm = 275
outer_diameter_mm = 180
flange_mm = 120
)";

/// The spindle that the reference cases name, its shaft in tables of their own.
inline const std::string base_spindle = R"([spindle]
name = "externally driven, 70 mm, two against one"

[bearing]
name = "7014 C like"
bore_mm = 70.0
outer_diameter_mm = 110.0
width_mm = 20.0
inner_ring_shoulder_mm = 82.0
outer_ring_shoulder_mm = 98.0
ball_count = 20
ball_diameter_mm = 11.9
pitch_diameter_mm = 90.0
contact_angle_deg = 15.0
inner_conformity = 0.52
outer_conformity = 0.52
static_load_rating_N = 45000
lubricant_conductance_W_K = 1.5

[arrangement]
layout = "O"
front = 2
rear = 1
mounting = "rigid"
preload_N = 300
front_position_mm = [60.0, 90.0]
rear_position_mm = [290.0]

[lubricant]
viscosity_40C_mm2_s = 20.0
viscosity_100C_mm2_s = 4.4

[friction]
f1_load = "F_b"
inner_heat_share = 0.5
f0 = 0.6
z = 0.0007
y = 0.33

[shaft]
bore_mm = 36.0
[[shaft.segment]]
length_mm = 50.0
diameter_mm = 104.0
[[shaft.segment]]
length_mm = 50.0
diameter_mm = 70.0
[[shaft.segment]]
length_mm = 180.0
diameter_mm = 82.0
[[shaft.segment]]
length_mm = 20.0
diameter_mm = 70.0
[[shaft.segment]]
length_mm = 75.0
diameter_mm = 60.0

[housing]
start_mm = 40.0
length_mm = 275.0
outer_diameter_mm = 180.0
flange_mm = 120.0
flange_length_mm = 20.0
flange_conductance_W_K = 4.0

[seat]
inner_interference_um = 6.0
outer_clearance_um = 4.0
roughness_um = 0.8
slope = 0.15
hardness_GPa = 3.0

[coolant]
fluid = "water"
flow_l_min = 2.0
inlet_temperature_C = 20.0
diameter_mm = 140.0
channel_depth_mm = 4.0
channel_width_mm = 10.0
pitch_mm = 14.0
start_mm = 60.0
end_mm = 300.0

[ambient]
emissivity = 0.85

[[sensor]]
name = "front_bearing"
part = "housing"
position_mm = 60.0
radius_mm = 57.0

[[sensor]]
name = "shaft_end"
part = "shaft"
position_mm = 365.0
radius_mm = 29.0
)";

/// The text with its one `from` replaced.
inline std::string with(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  if (at == text.npos) throw std::invalid_argument("not in the model: " + std::string(from));
  return text.replace(at, from.size(), to);
}

/// The base spindle with a further circuit behind a shorter first one. `from` in the circuit
/// becomes `to`.
inline std::string with_circuit(std::string_view from = "jacket", std::string_view to = "jacket") {
  const std::string circuit =
      "[[coolant.circuit]]\nname = \"jacket\"\nflow_l_min = 4\ninlet_temperature_C = 25\n"
      "diameter_mm = 140\nchannel_width_mm = 8\nchannel_depth_mm = 5\npitch_mm = 12\n"
      "start_mm = 190\nend_mm = 300\n";
  return with(base_spindle, "end_mm = 300.0", "end_mm = 180.0") + with(circuit, from, to);
}

}  // namespace raceway::tests
