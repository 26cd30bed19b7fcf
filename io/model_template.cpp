#include <fmt/format.h>

#include "io/catalogue_defaults.h"
#include "io/model_file.h"

namespace raceway::io {

namespace {

/// A line of [bearing], with its remark.
std::string key_line(const ModelRemarks& remarks, std::string_view key, const std::string& value,
                     std::string_view remark = {}) {
  for (const auto& [name, words] : remarks.of_key)
    if (name == key) remark = words;
  std::string line = fmt::format("{} = {}", key, value);
  if (!remark.empty()) line = fmt::format("{:<34} # {}", line, remark);
  return line + "\n";
}

}  // namespace

std::string new_model_text(const CatalogueBearing& row) {
  return model_text(
      row,
      {.title = fmt::format(
           "Model of a {} on a rig. Every default is written out: change what you know better.",
           row.full_name()),
       .ball_material = "steel",
       .of_key = {}});
}

std::string model_text(const CatalogueBearing& row, const ModelRemarks& remarks) {
  const bearing::BearingGeometry& g = row.geometry;
  const model::Rig rig;
  const auto number = [](double value) { return fmt::format("{:.10g}", value); };
  const bool known = !row.maker.empty();
  const std::string name = known ? row.full_name() : row.designation;
  std::string text = fmt::format("# {}\n\n", remarks.title);
  text +=
      known ? fmt::format("[bearing]                          # same as catalogue = \"{}\"\n", name)
            : "[bearing]\n";
  text += fmt::format("name = \"{}\"\n", name);
  const auto add = [&](std::string_view key, const std::string& value,
                       std::string_view remark = {}) {
    text += key_line(remarks, key, value, remark);
  };
  add("ball_count", fmt::format("{}", g.ball_count));
  add("ball_diameter_mm", number(g.ball_diameter / mm));
  add("pitch_diameter_mm", number(g.pitch_diameter / mm));
  add("contact_angle_deg", number(g.contact_angle / degree));
  add("inner_conformity", number(g.inner_conformity),
      "groove radius / ball diameter; makers do not print it: assumed");
  add("outer_conformity", number(g.outer_conformity), "assumed");
  add("static_load_rating_N", number(g.static_load_rating));
  add("bore_mm", number(g.bore / mm));
  add("outer_diameter_mm", number(g.outer_diameter / mm));
  add("ball_material", fmt::format("\"{}\"", remarks.ball_material),
      remarks.ball_material == "steel" ? "or \"silicon-nitride\", or a [material.NAME] as below"
                                       : "or \"steel\", or a [material.NAME] as below");
  text += R"(ring_material = "steel"

[lubricant]                        # assumed: a thin spindle oil; put in the values of yours
viscosity_40C_mm2_s = 22.0         # of a grease: of its base oil
viscosity_100C_mm2_s = 4.8
# supply = "oil-air"               # or "grease", "jet", "bath": rules out effects that need another
)";
  text += fmt::format(R"(
[friction]
law = "palmgren"                   # or "skf", then mu_bl, mu_EHL and K_rs in place of f0, z and y
f0 = {}                           # viscous torque, about 1 (oil-air, little grease) to 6 (oil jet)
z = {}                          # load torque
y = {}                           # exponent of the load torque
f1_load = "P0"                     # or "F_b", in the factor z (P0/C0)^y of the load torque

[rig]
bearings = {}                       # equal bearings whose torque the rig sees
# axial_load_N = 0                 # per bearing, for measured rows without that column
radial_load_N = {}
temperature_C = {}
minimum_speed_rpm = {}              # slower rows of a coast-down are left out
# inertia_kgm2 = 0.5               # of all that turns; coast-down records need it, or "unknown"

[solver]
race_control = "outer"             # or "inner"
tilt = "locked"                    # or "free"

[calibration]
free = ["f0", "z"]                 # what may be re-fitted to measurements

# [material.my-ball]
# elastic_modulus_GPa = 208
# poisson_ratio = 0.3
# density_kg_m3 = 7800
# thermal_expansion_1e6_K = 11.5
)",
                      catalogue_f0, catalogue_z, catalogue_y, rig.bearings, number(rig.radial_load),
                      number(celsius(rig.temperature)), number(rig.minimum_speed / rpm));
  return text;
}

}  // namespace raceway::io
