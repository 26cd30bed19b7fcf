#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/spindle_study/rig.h"

namespace spindle_study {
namespace {

constexpr double zero_C = 273.15;

void put(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::string list_mm(const std::vector<double>& metres) {
  std::string text;
  for (double m : metres) text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", m * 1e3);
  return "[" + text + "]";
}

std::string_view name(Thermometer::Part part) {
  switch (part) {
    case Thermometer::Part::shaft:
      return "shaft";
    case Thermometer::Part::ring:
      return "ring";
    default:
      return "housing";
  }
}

std::string model_text(const Rig& rig) {
  const Spindle& s = rig.believed;
  const BearingData& b = s.bearing;
  std::string t = fmt::format(
      "[spindle]\nname = \"study {}\"\npreload_feedback = {}\n\n"
      "[bearing]\nname = \"7014 C like\"\nbore_mm = {:.6g}\nouter_diameter_mm = {:.6g}\n"
      "width_mm = {:.6g}\ninner_ring_shoulder_mm = {:.6g}\nouter_ring_shoulder_mm = {:.6g}\n"
      "ball_count = {}\nball_diameter_mm = {:.6g}\npitch_diameter_mm = {:.6g}\n"
      "contact_angle_deg = {:.6g}\ninner_conformity = {}\nouter_conformity = {}\n"
      "static_load_rating_N = {:.6g}\nlubricant_conductance_W_K = {}\n\n",
      rig.id, s.preload_feedback, s.bearing_bore * 1e3, s.bearing_outer * 1e3,
      s.bearing_width * 1e3, s.inner_shoulder * 1e3, s.outer_shoulder * 1e3, b.ball_count,
      b.ball_diameter * 1e3, b.pitch_diameter * 1e3, b.contact_angle * 180.0 / pi,
      b.inner_conformity, b.outer_conformity, b.static_rating, s.lubricant_conductance);
  t += fmt::format(
      "[arrangement]\nlayout = \"O\"\nfront = {}\nrear = {}\nmounting = \"rigid\"\n"
      "preload_N = {:.6g}\nfront_position_mm = {}\nrear_position_mm = {}\n\n"
      "[lubricant]\nviscosity_40C_mm2_s = {:.6g}\nviscosity_100C_mm2_s = {:.6g}\n\n"
      "[friction]\nf1_load = \"F_b\"\ninner_heat_share = 0.5\nf0 = {:.6g}\nz = {:.6g}\n"
      "y = {:.6g}\n\n[shaft]\nbore_mm = {:.6g}\n",
      s.front.size(), s.rear.size(), s.preload, list_mm(s.front), list_mm(s.rear), s.oil.at_40,
      s.oil.at_100, s.f0, s.z, s.y, s.shaft_bore * 1e3);
  for (const ShaftPiece& p : s.shaft)
    t += fmt::format("[[shaft.segment]]\nlength_mm = {:.9g}\ndiameter_mm = {:.9g}\n",
                     p.length * 1e3, p.diameter * 1e3);
  t += fmt::format(
      "\n[housing]\nstart_mm = {:.9g}\nlength_mm = {:.9g}\nouter_diameter_mm = {:.9g}\n"
      "flange_mm = {:.9g}\nflange_length_mm = {:.9g}\nflange_conductance_W_K = {:.9g}\n\n"
      "[seat]\ninner_interference_um = {:.9g}\nouter_clearance_um = {:.9g}\n"
      "roughness_um = {:.9g}\nslope = {:.9g}\nhardness_GPa = {:.9g}\n\n",
      s.housing_start * 1e3, s.housing_length * 1e3, s.housing_diameter * 1e3, s.flange * 1e3,
      s.flange_length * 1e3, s.flange_conductance, s.interference * 1e6, s.clearance * 1e6,
      s.roughness * 1e6, s.slope, s.hardness * 1e-9);
  if (s.cooled) {
    const Helix& h = s.helix;
    t += fmt::format(
        "[coolant]\nfluid = \"water\"\nflow_l_min = {:.9g}\ninlet_temperature_C = {:.9g}\n"
        "diameter_mm = {:.9g}\nchannel_depth_mm = {:.9g}\nchannel_width_mm = {:.9g}\n"
        "pitch_mm = {:.9g}\nstart_mm = {:.9g}\nend_mm = {:.9g}\n\n",
        h.flow * 60e3, h.inlet - zero_C, h.diameter * 1e3, h.depth * 1e3, h.width * 1e3,
        h.pitch * 1e3, h.start * 1e3, h.end * 1e3);
  }
  t += fmt::format("[ambient]\nemissivity = {}\n\n[calibration]\nfree = [\"f0\"]\n", s.emissivity);
  for (const Thermometer& m : s.thermometers)
    t += fmt::format(
        "\n[[sensor]]\nname = \"{}\"\npart = \"{}\"\nposition_mm = {:.9g}\n"
        "radius_mm = {:.9g}\n",
        m.name, name(m.part), m.position * 1e3, m.radius * 1e3);
  return t;
}

std::string record_text(const Rig& rig, const std::vector<Row>& rows) {
  const bool cooled = rig.believed.cooled;
  std::string t =
      fmt::format("time_s,speed_rpm,ambient_temperature_C{}", cooled ? ",coolant_on" : "");
  for (const Thermometer& m : rig.believed.thermometers)
    t += fmt::format(",{}_temperature_C", m.name);
  t += ",axial_displacement_um\n";
  for (const Row& row : rows) {
    t += fmt::format("{:.0f},{:.6g},{:.2f}", row.inputs.time, row.inputs.speed * 30.0 / pi,
                     row.ambient_read - zero_C);
    if (cooled) t += row.inputs.coolant_on ? ",1" : ",0";
    for (double v : row.thermometers_read) t += fmt::format(",{:.2f}", v - zero_C);
    t += fmt::format(",{:.3f}\n", row.displacement_read * 1e6);
  }
  return t;
}

nlohmann::json truth_of(const Rig& rig, const std::vector<Row>& rows) {
  nlohmann::json j;
  const auto rounded = [](double v, double digits) { return std::round(v * digits) / digits; };
  for (const Row& row : rows) {
    const Reading& r = row.truth;
    j["displacement_um"].push_back(rounded(r.displacement * 1e6, 1e4));
    for (std::size_t k = 0; k < r.thermometers.size(); ++k)
      j[rig.believed.thermometers[k].name + "_temperature_C"].push_back(
          rounded(r.thermometers[k] - zero_C, 1e3));
    double power = 0.0;
    for (double p : r.power) power += p;
    j["friction_power_W"].push_back(rounded(power, 1e2));
    j["front_force_N"].push_back(rounded(r.set.front_force, 1e1));
    j["inner_ring_front_1_C"].push_back(rounded(r.inner_rings.front() - zero_C, 1e2));
  }
  return j;
}

std::string truth_text(const Rig& rig) {
  nlohmann::json j;
  j["hidden"] = nlohmann::json::object();
  if (rig.kind != "nothing")
    j["hidden"][rig.kind] =
        std::isnan(rig.size) ? nlohmann::json(nullptr) : nlohmann::json(rig.size);
  j["accept"] = rig.accept;
  j["verdicts"] = rig.verdicts;
  j["size"] = std::isnan(rig.size) ? nlohmann::json(nullptr) : nlohmann::json(rig.size);
  j["signal"] = rig.signal;
  j["friction"] = {{"f0", rig.truth.f0}};
  j["sigma"] = {{"temperature_K", 0.1}, {"displacement_um", 0.3}};
  j["cells"] = rig.cells;
  j["balance"] = rig.balance;
  j["train"] = truth_of(rig, rig.train);
  j["test"] = truth_of(rig, rig.test);
  return j.dump() + "\n";
}

}  // namespace

void write_rig(const Rig& rig, const std::string& folder) {
  const std::filesystem::path path = std::filesystem::path(folder) / rig.id;
  std::filesystem::create_directories(path);
  put(path / "model.toml", model_text(rig));
  put(path / "train.csv", record_text(rig, rig.train));
  put(path / "test.csv", record_text(rig, rig.test));
  put(path / "truth.json", truth_text(rig));
}

}  // namespace spindle_study
