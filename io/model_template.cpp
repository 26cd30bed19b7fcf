#include <fmt/format.h>

#include "io/catalogue_defaults.h"
#include "io/model_file.h"

namespace raceway::io {

std::string new_model_text(const CatalogueBearing& row) {
  const bearing::BearingGeometry& g = row.geometry;
  const model::Rig rig;
  const auto number = [](double value) { return fmt::format("{:.10g}", value); };
  std::string text = fmt::format(
      R"(# Model of a {0} on a rig. Every default is written out: change what you know better.

[bearing]                          # same as catalogue = "{0}"
name = "{0}"
ball_count = {1}
ball_diameter_mm = {2}
pitch_diameter_mm = {3}
contact_angle_deg = {4}
inner_conformity = {5}            # groove radius / ball diameter; makers do not print it: assumed
outer_conformity = {6}            # assumed
static_load_rating_N = {7}
bore_mm = {8}
outer_diameter_mm = {9}
ball_material = "steel"            # or "silicon-nitride", or a [material.NAME] as below
ring_material = "steel"

[lubricant]                        # assumed: a thin spindle oil; put in the values of yours
viscosity_40C_mm2_s = 22.0         # of a grease: of its base oil
viscosity_100C_mm2_s = 4.8
# supply = "oil-air"               # or "grease", "jet", "bath": rules out effects that need another
)",
      row.full_name(), g.ball_count, number(g.ball_diameter / mm), number(g.pitch_diameter / mm),
      number(g.contact_angle / degree), number(g.inner_conformity), number(g.outer_conformity),
      number(g.static_load_rating), number(g.bore / mm), number(g.outer_diameter / mm));
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
