#include "io/model_keys.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/correction_file.h"
#include "io/json_text.h"
#include "io/key_book.h"
#include "io/key_meanings.h"
#include "io/model_file.h"

namespace raceway::io {
namespace {

// Models that are read to see what their readers ask for. Between them they have every table; keys
// are left out where a default is to be seen.

constexpr const char* rig_model = R"(
[bearing]
ball_count = 21
ball_diameter_mm = 11.906
pitch_diameter_mm = 90
contact_angle_deg = 15
inner_conformity = 0.52
outer_conformity = 0.52
static_load_rating_N = 46000
[material.NAME]
elastic_modulus_GPa = 208
poisson_ratio = 0.3
density_kg_m3 = 7800
thermal_expansion_1e6_K = 11.5
[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8
[friction]
f0 = 1.5
z = 0.001
y = 0.33
[rig]
inertia_kgm2 = 0.01
[loop]
tolerance_Nmm = 2
[columns]
speed_rpm = { column = "n", unit = "rpm", factor = 1 }
[torque_sensor]
coefficients = [0.03, 4.9]
units = ["V", "V/Nm"]
std = [0.0003, 0.0006]
correlation = [[1], [-0.8, 1]]
residual_std_V = 0.001
torque_from_Nm = 0
torque_to_Nm = 1
signal_from_V = 0
signal_to_V = 5
zero_V = 0.03
zero_std_V = 0.001
[calibration]
free = ["f0"]
[calibration.covariance]
parameters = ["f0"]
units = ["1"]
values = [1.5]
std = [0.1]
correlation = [[1]]
[[effect]]
id = "own"
torque_Nmm = "c*speed_rpm"
c = { value = 1, unit = "N mm", lower = 0, upper = 2 }
)";

constexpr const char* short_rig = R"(
[bearing]
catalogue = "S 6014 C"
[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8
[friction]
law = ")";

constexpr const char* spindle_model = R"(
[bearing]
catalogue = "S 6014 C"
[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8
[arrangement]
layout = "O"
front = 2
rear = 1
preload_N = 300
front_position_mm = [60, 90]
rear_position_mm = [290]
front_bearing = { offset_um = 0 }
[shaft]
segment = [{ length_mm = 355, diameter_mm = 70, bore_mm = 30, material = "steel" }]
disk = [{ position_mm = 10, mass_kg = 1, diametral_inertia_kgm2 = 0.001, polar_inertia_kgm2 = 0.001 }]
support = [{ position_mm = 340, radial_N_um = 100 }]
[housing]
start_mm = 40
segment = [{ length_mm = 275, outer_diameter_mm = 180, material = "cast-iron" }]
flange_mm = 120
[motor]
heat_W = 100
position_mm = 200
length_mm = 50
[drive]
heat_W = 10
[coolant]
flow_l_min = 2
diameter_mm = 140
channel_depth_mm = 4
channel_width_mm = 10
pitch_mm = 14
start_mm = 60
end_mm = 300
[gap]
inner_diameter_mm = 90
outer_diameter_mm = 100
start_mm = 120
end_mm = 180
[loop]
tolerance_K = 1
tolerance_um = 1
[[sensor]]
name = "front"
part = "housing"
position_mm = 60
radius_mm = 80
)";

constexpr const char* whole_housing = R"(
[bearing]
catalogue = "S 6014 C"
[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8
[arrangement]
layout = "O"
front = 2
rear = 1
mounting = "spring"
preload_N = 300
front_position_mm = [60, 90]
rear_position_mm = [290]
[shaft]
segment = [{ length_mm = 355, diameter_mm = 70 }]
[housing]
start_mm = 40
length_mm = 275
outer_diameter_mm = 180
flange_mm = 120
)";

// In the place of a preload.
constexpr const char* class_and_offset = R"(
[bearing]
catalogue = "S 6014 C"
[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8
[arrangement]
layout = "O"
front = 1
rear = 1
distance_mm = 100
inner_ring_temperature_C = 30
outer_ring_temperature_C = 30
)";

constexpr const char* network = R"(
[bearing]
catalogue = "S 6014 C"
[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8
[arrangement]
layout = "O"
front = 2
rear = 1
preload_N = 300
[network]
node = [{ name = "rotor", capacity_J_K = 900, heat_W = 40 }, { name = "body", capacity_J_K = 20000 }]
link = [{ from = "rotor", to = "body", conductance_W_K = 5 }, { from = "body", to = "ambient", conductance_W_K = 2 }]
)";

constexpr const char* correction_of_lags = R"(
[correction]
displacement = "displacement_z_um"
sampling_s = 10
kinematic = { A = 1, B = 0.5, C = 0.0005 }
range = { front_temperature_C = [20, 30] }
together = { columns = ["front_temperature_C"], mean = [25], std = [2], correlation = [[1]], farthest = 3 }
residual = { rms_um = 1, correlation_time_s = 100 }
[correction.covariance]
parameters = ["offset"]
units = ["um"]
values = [0]
std = [0.1]
correlation = [[1]]
[[correction.channel]]
name = "lags"
input = "front_temperature_C"
sections = [{ gain_um_K = 5, time_constant_s = 3600 }]
[[correction.channel]]
name = "polynomial"
input = "rear_temperature_C"
numerator = [1.0]
denominator = [1.0, -0.5]
[[correction.effect]]
id = "ambient-drift"
input = "room_temperature_C"
gain_um_K = 1
time_constant_s = 900
[[correction.effect]]
id = "own"
formula = "speed_rpm"
gain_um = 0
time_constant_s = 900
[export]
)";

/// Names that are one's own, tables in braces and defaults that only this model has, in general.
void take_general_name(ModelKey& key) {
  constexpr std::array general{std::pair{"effect own, c", "effect.PARAMETER"},
                               std::pair{"columns.speed_rpm", "columns.COLUMN"},
                               std::pair{"sections", "correction.channel.sections"}};
  for (const auto& [as_asked, name] : general)
    if (key.table == as_asked) key.table = name;
  if (key.table == "effect.PARAMETER") key.unit.clear();
  if (key.table == "bearing" && key.name == "name")
    key.fallback = "that of the catalogue, else of the file";
  if (key.table == "calibration" && key.name == "free") key.fallback = "those of the law";
}

}  // namespace

std::vector<ModelKey> model_keys() {
  KeyBook book;
  const std::string name = "model.toml";
  (void)parse_model(rig_model, name);
  for (const char* law : {"palmgren", "skf", "contact"})
    (void)parse_model(std::string(short_rig) + law + "\"\n", name);
  for (const char* text : {spindle_model, whole_housing, network}) (void)parse_model(text, name);
  for (const char* preload : {"preload_class = \"light\"", "preload_offset_um = 5"})
    (void)parse_model(std::string(class_and_offset) + preload + "\n", name);
  (void)parse_correction(correction_of_lags, name);
  std::vector<ModelKey> keys = book.keys();
  // A bearing of a set has the keys of [bearing], and one more.
  std::erase_if(keys, [](const ModelKey& key) {
    return key.table == "arrangement.front_bearing" && key.name != "offset_um";
  });
  for (ModelKey& key : keys) {
    take_general_name(key);
    for (const KeyMeaning& one : key_meanings())
      if (one.table == key.table && one.name == key.name) key.meaning = one.meaning;
  }
  // By table, in the order in which the meanings stand; what has none comes last.
  const auto place = [](const ModelKey& key) {
    const auto all = key_meanings();
    return std::find_if(all.begin(), all.end(),
                        [&](const KeyMeaning& one) {
                          return one.table == key.table && one.name == key.name;
                        }) -
           all.begin();
  };
  std::stable_sort(keys.begin(), keys.end(),
                   [&](const ModelKey& a, const ModelKey& b) { return place(a) < place(b); });
  return keys;
}

std::string model_keys_json(std::span<const ModelKey> keys) {
  const auto or_null = [](const std::string& words) {
    return words.empty() ? json(nullptr) : json(words);
  };
  json list = json::array();
  for (const ModelKey& key : keys)
    list.push_back({{"table", key.table},
                    {"key", key.name},
                    {"unit", or_null(key.unit)},
                    {"from", key.lower},
                    {"to", key.upper},
                    {"whole_number", key.whole},
                    {"required", key.required},
                    {"choices", key.choices},
                    {"default", or_null(key.fallback)},
                    {"meaning", key.meaning}});
  return text({{"keys", list}});
}

}  // namespace raceway::io
