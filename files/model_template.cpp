#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/catalogue_defaults.h"
#include "files/model_file.h"
#include "files/oil_grade.h"
#include "friction/contact/contact_data.h"
#include "friction/friction_law.h"
#include "model/parameters.h"
#include "model/spindle.h"
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

/// [friction] of a law, with what each number is. Measurements of a rig fit these numbers; those of
/// a spindle are assumed.
std::string friction_lines(friction::FrictionLaw law, bool of_spindle) {
  const auto initial = [&](std::string_view name) {
    for (const friction::Parameter& p : friction::parameters(law))
      if (p.name == name) return fmt::format("{:g}", p.initial);
    return std::string();
  };
  std::string text = "\n[friction]\n";
  const auto add = [&](std::string_view key, const std::string& value, std::string_view remark) {
    const bool assumed = of_spindle && value.front() != '"';
    text += key_line({}, key, value, fmt::format("{}{}", assumed ? "assumed: " : "", remark));
  };
  switch (law) {
    case friction::FrictionLaw::palmgren:
      add("law", "\"palmgren\"",
          "or \"skf\", \"contact\"; raceway new --law writes a model with such a law");
      add("f0", fmt::format("{}", catalogue_f0),
          "factor of the viscous torque, about 1 (oil-air, little grease) to 6 (oil jet)");
      add("z", fmt::format("{}", catalogue_z), "factor of the load torque");
      add("y", fmt::format("{}", catalogue_y), "exponent of P0/C0 in the load torque");
      add("f1_load", "\"P0\"", "load in the factor z (P0/C0)^y of the load torque; or \"F_b\"");
      break;
    case friction::FrictionLaw::skf:
      add("law", "\"skf\"",
          "or \"palmgren\", \"contact\"; raceway new --law writes a model with such a law");
      add("mu_bl", initial("mu_bl"), "friction coefficient of the asperity contacts, at low speed");
      add("mu_EHL", initial("mu_EHL"), "friction coefficient of a full film");
      add("K_rs", initial("K_rs"), "3e-8 oil bath or jet, 6e-8 grease or oil-air");
      break;
    case friction::FrictionLaw::contact:
      text +=
          "# To diagnose measured torque, start with \"palmgren\", which has two free "
          "parameters.\n# raceway add MODEL law:palmgren --data RIG.csv -o NEW.toml changes to "
          "this law and fits it.\n";
      add("law", "\"contact\"",
          "sum of the friction of all balls; or \"palmgren\", \"skf\"; raceway new --law writes a "
          "model with such a law");
      add("rolling_factor", initial("rolling_factor"),
          "factor on the rolling resistance of the oil, which causes most of the torque at high "
          "speed; known to +-40 %");
      add("hysteresis_factor", initial("hysteresis_factor"),
          "factor on the hysteresis loss of the steel");
      add("mu_boundary", initial("mu_boundary"),
          "friction coefficient of the asperity contacts, which carry load at film ratios below 2");
      add("K_rs", initial("K_rs"),
          "replenishment of the oil: 3e-8 bath or jet, 6e-8 grease or oil-air; 0: no starvation");
      add("oil_fraction", initial("oil_fraction"),
          "share of the free space that is filled with oil; 0: no drag");
      break;
    case friction::FrictionLaw::table:
    case friction::FrictionLaw::powers:
    case friction::FrictionLaw::contact_powers:
      break;  // measurements make such a model
    case friction::FrictionLaw::roller_palmgren:
    case friction::FrictionLaw::roller_skf:
      break;  // files/roller_estimate.h writes models of rollers
  }
  return text;
}

std::string free_list(friction::FrictionLaw law) {
  std::string list;
  for (const std::string& name : model::default_free(law))
    list += (list.empty() ? "\"" : ", \"") + name + "\"";
  return "[" + list + "]";
}

/// Of the rings [m], as a spindle takes it.
double width_of(const CatalogueBearing& row) {
  const bearing::BearingGeometry& g = row.geometry;
  return std::isnan(row.width) ? 0.5 * (g.outer_diameter - g.bore) : row.width;
}

/// The rig, and how measurements are fitted to.
std::string rig_lines(friction::FrictionLaw law) {
  const model::Rig rig;
  return fmt::format(R"(
[rig]
bearings = {}                       # equal bearings; the reading is the sum of their torques
# axial_load_N = 0                 # of one bearing, for records without this column
radial_load_N = {:.10g}
temperature_C = {:.10g}
minimum_speed_rpm = {:.10g}              # slower rows of a coast-down are not used
# inertia_kgm2 = 0.5               # of all rotating parts, or "unknown"; required for coast-down records

[solver]
race_control = "outer"             # or "inner"; with the contact law also "balanced"
tilt = "locked"                    # or "free"

[calibration]
{:<34} # parameters that a fit changes

# [material.my-ball]
# elastic_modulus_GPa = 208
# poisson_ratio = 0.3
# density_kg_m3 = 7800
# thermal_expansion_1e6_K = 11.5
)",
                     rig.bearings, rig.radial_load, celsius(rig.temperature),
                     rig.minimum_speed / rpm, "free = " + free_list(law));
}

/// Two bearings at the tool against one at the rear, on a shaft whose pieces go with the width of
/// the bearings, and in a housing that fits them.
std::string spindle_lines(const CatalogueBearing& row) {
  const bearing::BearingGeometry& g = row.geometry;
  const double bore = g.bore / mm, outer = g.outer_diameter / mm, section = outer - bore,
               width = width_of(row) / mm;
  const auto rounded = [](double value, double to) { return to * std::round(value / to); };
  const double preload = std::max(10.0, rounded(7e-3 * g.static_load_rating, 10.0));
  const double nose = 2.5 * width, seat = 2.5 * width, middle = 9.0 * width, tail = 3.75 * width;
  const double first = nose + 0.5 * width, rear = nose + seat + middle + 0.5 * width;
  const auto segment = [](double length, double diameter) {
    return fmt::format("{{length_mm = {:.6g}, diameter_mm = {:.6g}}}", length, diameter);
  };
  std::string text = "\n[arrangement]\n";
  const auto add = [&](std::string_view key, const std::string& value, std::string_view remark) {
    text += key_line({}, key, value, remark);
  };
  const auto number = [](double value) { return fmt::format("{:.6g}", value); };
  add("layout", "\"O\"", "or \"X\"");
  add("front", "2", "assumed: number of bearings at the tool");
  add("rear", "1", "assumed");
  add("mounting", "\"rigid\"", "or \"spring\"; assumed");
  add("preload_N", number(preload), "assumed: preload at standstill, 0.7 % of C0");
  add("front_position_mm", fmt::format("[{:.6g}, {:.6g}]", first, first + 1.5 * width),
      "assumed: distances of the bearing centres behind the nose face");
  add("rear_position_mm", fmt::format("[{:.6g}]", rear), "assumed");
  text += fmt::format(
      R"(
[shaft]                            # assumed, from the nose to the rear: replace by your drawing
bore_mm = {:.6g}
segment = [
  {},
  {},   # seat of the front bearings
  {},
  {},   # seat of the rear bearing
  {},
]

[housing]                          # assumed; bored to the outer diameter of the bearings
start_mm = {:.6g}                      # distance of its front face behind the nose face
length_mm = {:.6g}
outer_diameter_mm = {:.6g}
flange_mm = {:.6g}                    # distance of the middle of the mounting flange behind the nose face

[ambient]
)",
      rounded(0.5 * bore, 0.5), segment(nose, rounded(outer - 0.15 * section, 0.5)),
      segment(seat, bore), segment(middle, rounded(bore + 0.3 * section, 0.5)),
      segment(width, bore), segment(tail, rounded(0.86 * bore, 0.5)), 2.0 * width, 13.75 * width,
      rounded(outer + 1.75 * section, 1.0), 6.0 * width);
  add("temperature_C", number(celsius(model::Ambient{}.temperature)),
      "assumed: temperature of the air");
  text += fmt::format(
      R"(
[[sensor]]                         # column front_bearing_temperature_C of a record
name = "front_bearing"
part = "housing"
position_mm = {:.6g}                   # assumed: next to the first bearing
radius_mm = {:.6g}                     # assumed

[columns]
settings_hold = "until row"        # for loggers whose time is the end of an interval; "from row" for a list of events

# Fits, coolant, motor and drive: raceway keys "[seat]", "[coolant]", "[motor]", "[drive]".
# raceway check THIS-FILE lists every default that is used.
)",
      first, rounded(0.5 * outer + 0.05 * section, 0.5));
  return text;
}

/// What [lubricant] and [bearing] have more under the contact law.
std::string contact_lubricant_lines(friction::FrictionLaw law) {
  if (law != friction::FrictionLaw::contact) return "";
  return key_line({}, "type", "\"mineral\"",
                  "or \"pao\", \"ester\"; sets the defaults of the next four keys") +
         "# density_15C_kg_m3 = 880          # mineral; pao 830, ester 930\n"
         "# conductivity_W_mK = 0.13         # mineral; pao and ester 0.15\n"
         "# pressure_viscosity_1_GPa = 15    # mineral: 9.904 nu^0.139, kinematic viscosity nu in "
         "mm2/s\n"
         "# limiting_traction = 0.06         # mineral; pao 0.045, ester 0.04; has an effect above "
         "a contact pressure of 1.2 GPa\n" +
         key_line({}, "eyring_stress_MPa", "5",
                  "shear stress above which the oil shows shear thinning");
}

}  // namespace

std::string new_model_text(const CatalogueBearing& row, friction::FrictionLaw law) {
  return model_text(row, {.law = law});
}

std::string model_text(const CatalogueBearing& row, const ModelRemarks& remarks) {
  const bearing::BearingGeometry& g = row.geometry;
  const auto number = [](double value) { return fmt::format("{:.10g}", value); };
  const bool known = !row.maker.empty();
  const std::string name = known ? row.full_name() : row.designation;
  std::string title = remarks.title;
  if (remarks.of_spindle)
    title = fmt::format(
        "A complete spindle on three bearings {}. Enter your own values\n# where a value is marked "
        "as assumed or estimated.",
        name);
  else if (title.empty())
    title = fmt::format(
        "Model of a {}{} on a rig. All defaults are written out: replace them by your own values.",
        remarks.ball_material == "steel" ? "" : "hybrid ", name);
  std::string text = fmt::format("# {}\n\n{}\n", title, text::format_line);
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
      "assumed: groove radius / ball diameter, which makers do not print");
  add("outer_conformity", number(g.outer_conformity), "assumed");
  add("static_load_rating_N", number(g.static_load_rating));
  add("bore_mm", number(g.bore / mm));
  add("outer_diameter_mm", number(g.outer_diameter / mm));
  if (remarks.of_spindle)
    add("width_mm", number(width_of(row) / mm),
        std::isnan(row.width) ? "estimated: (outer diameter - bore) / 2" : "ring width");
  add("ball_material", fmt::format("\"{}\"", remarks.ball_material),
      remarks.ball_material == "steel" ? "or \"silicon-nitride\", or a [material.NAME] as below"
                                       : "or \"steel\", or a [material.NAME] as below");
  text += "ring_material = \"steel\"\n";
  if (remarks.law == friction::FrictionLaw::contact) {
    const friction::contact::ContactData data;
    add("race_roughness_um", number(data.race_roughness / um), "Rq; assumed");
    add("ball_roughness_um", number(data.ball_roughness / um), "Rq; assumed");
  }
  text += lubricant_lines(remarks.oil) +
          "# supply = \"oil-air\"               # or \"grease\", \"jet\", \"bath\": rules out "
          "effects that need another supply\n";
  text += contact_lubricant_lines(remarks.law) + friction_lines(remarks.law, remarks.of_spindle);
  return text + (remarks.of_spindle ? spindle_lines(row) : rig_lines(remarks.law));
}

}  // namespace raceway::files
