#include <fmt/format.h>

#include "files/catalogue_defaults.h"
#include "files/model_file.h"
#include "friction/contact/contact_data.h"
#include "friction/friction_law.h"
#include "model/parameters.h"
#include "text/format_number.h"

namespace raceway::files {

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

/// [friction] of a law, with what each number is.
std::string friction_lines(friction::FrictionLaw law) {
  const auto initial = [&](std::string_view name) {
    for (const friction::Parameter& p : friction::parameters(law))
      if (p.name == name) return fmt::format("{:g}", p.initial);
    return std::string();
  };
  std::string text = "\n[friction]\n";
  const auto add = [&](std::string_view key, const std::string& value, std::string_view remark) {
    text += key_line({}, key, value, remark);
  };
  switch (law) {
    case friction::FrictionLaw::palmgren:
      add("law", "\"palmgren\"", "or \"skf\", \"contact\": raceway new --law writes their numbers");
      add("f0", fmt::format("{}", catalogue_f0),
          "viscous torque, about 1 (oil-air, little grease) to 6 (oil jet)");
      add("z", fmt::format("{}", catalogue_z), "load torque");
      add("y", fmt::format("{}", catalogue_y), "exponent of the load torque");
      add("f1_load", "\"P0\"", "or \"F_b\", in the factor z (P0/C0)^y of the load torque");
      break;
    case friction::FrictionLaw::skf:
      add("law", "\"skf\"", "or \"palmgren\", \"contact\": raceway new --law writes their numbers");
      add("mu_bl", initial("mu_bl"), "friction where asperities touch, at low speed");
      add("mu_EHL", initial("mu_EHL"), "friction of a full film");
      add("K_rs", initial("K_rs"), "3e-8 oil bath or jet, 6e-8 grease or oil-air");
      break;
    case friction::FrictionLaw::contact:
      text +=
          "# To diagnose measured torque begin with \"palmgren\": two free numbers, a verdict in a "
          "second.\n"
          "# raceway add MODEL law:palmgren --data RIG.csv -o NEW.toml takes it, calibrated.\n";
      add("law", "\"contact\"",
          "sums over the balls; or \"palmgren\", \"skf\": raceway new --law writes their numbers");
      add("rolling_factor", initial("rolling_factor"),
          "on the oil's resistance to rolling, most of the torque at speed; known to +-40 %");
      add("hysteresis_factor", initial("hysteresis_factor"),
          "on what the steel does not give back of its deformation");
      add("mu_boundary", initial("mu_boundary"),
          "friction where asperities touch: below lambda 2, at low speed");
      add("K_rs", initial("K_rs"),
          "oil that flows back too slowly: 3e-8 bath or jet, 6e-8 grease or oil-air; 0 is off");
      add("oil_fraction", initial("oil_fraction"),
          "of the free space that is oil, which drags on the balls; 0 is no drag");
      break;
    case friction::FrictionLaw::roller_palmgren:
    case friction::FrictionLaw::roller_skf:
      break;  // files/roller_estimate.h writes models of rollers
  }
  return text;
}

/// What [lubricant] and [bearing] have more under the contact law.
std::string contact_lubricant_lines(friction::FrictionLaw law) {
  if (law != friction::FrictionLaw::contact) return "";
  return key_line({}, "type", "\"mineral\"",
                  "or \"pao\", \"ester\"; what stands below follows from it") +
         "# density_15C_kg_m3 = 880          # mineral; pao 830, ester 930\n"
         "# conductivity_W_mK = 0.13         # mineral; pao and ester 0.15\n"
         "# pressure_viscosity_1_GPa = 15    # of mineral oil 9.904 nu^0.139, nu in mm2/s\n"
         "# limiting_traction = 0.06         # of the film; pao 0.045, ester 0.04; matters above "
         "1.2 GPa\n" +
         key_line({}, "eyring_stress_MPa", "5", "shear stress above which a film thins");
}

std::string free_list(friction::FrictionLaw law) {
  std::string list;
  for (const std::string& name : model::default_free(law))
    list += (list.empty() ? "\"" : ", \"") + name + "\"";
  return "[" + list + "]";
}

}  // namespace

std::string new_model_text(const CatalogueBearing& row, friction::FrictionLaw law) {
  return model_text(
      row,
      {.title = fmt::format(
           "Model of a {} on a rig. Every default is written out: change what you know better.",
           row.full_name()),
       .ball_material = "steel",
       .of_key = {},
       .law = law});
}

std::string model_text(const CatalogueBearing& row, const ModelRemarks& remarks) {
  const bearing::BearingGeometry& g = row.geometry;
  const model::Rig rig;
  const auto number = [](double value) { return fmt::format("{:.10g}", value); };
  const bool known = !row.maker.empty();
  const std::string name = known ? row.full_name() : row.designation;
  std::string text = fmt::format("# {}\n\n{}\n", remarks.title, text::format_line);
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
  text += "ring_material = \"steel\"\n";
  if (remarks.law == friction::FrictionLaw::contact) {
    const friction::contact::ContactData data;
    add("race_roughness_um", number(data.race_roughness / um), "Rq; assumed");
    add("ball_roughness_um", number(data.ball_roughness / um), "Rq; assumed");
  }
  text += R"(
[lubricant]                        # assumed: a thin spindle oil; put in the values of yours
viscosity_40C_mm2_s = 22.0         # of a grease: of its base oil
viscosity_100C_mm2_s = 4.8
# supply = "oil-air"               # or "grease", "jet", "bath": rules out effects that need another
)";
  text += contact_lubricant_lines(remarks.law) + friction_lines(remarks.law);
  text += fmt::format(R"(
[rig]
bearings = {}                       # equal bearings whose torque the rig sees
# axial_load_N = 0                 # per bearing, for measured rows without that column
radial_load_N = {}
temperature_C = {}
minimum_speed_rpm = {}              # slower rows of a coast-down are left out
# inertia_kgm2 = 0.5               # of all that turns; coast-down records need it, or "unknown"

[solver]
race_control = "outer"             # or "inner"; of the contact law "balanced"
tilt = "locked"                    # or "free"

[calibration]
{:<34} # what may be re-fitted to measurements

# [material.my-ball]
# elastic_modulus_GPa = 208
# poisson_ratio = 0.3
# density_kg_m3 = 7800
# thermal_expansion_1e6_K = 11.5
)",
                      rig.bearings, number(rig.radial_load), number(celsius(rig.temperature)),
                      number(rig.minimum_speed / rpm), "free = " + free_list(remarks.law));
  return text;
}

}  // namespace raceway::files
