#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/spindle.h"
#include "record/units.h"
#include "tests/spindle/reference.h"

namespace raceway::spindle::test {

/// A case of beams.
inline nlohmann::json beam_case(const std::string& id) { return reference(id); }

inline model::SolidMaterial beam_material(const nlohmann::json& in) {
  model::SolidMaterial m;
  m.elastic_modulus = in.at("E_Pa");
  m.poissons_ratio = in.contains("G_Pa")
                         ? m.elastic_modulus / (2.0 * in.at("G_Pa").get<double>()) - 1.0
                         : in.at("nu").get<double>();
  m.density = in.at("rho");
  return m;
}

/// The shaft of the spindle cases.
inline model::ShaftBody spindle_shaft(const nlohmann::json& in) {
  model::ShaftBody body;
  const double sections[][2] = {{50, 104}, {50, 70}, {180, 82}, {20, 70}, {75, 60}};
  for (const auto& [length, diameter] : sections)
    body.segments.push_back({.length = length * mm,
                             .diameter = diameter * mm,
                             .bore = 36 * mm,
                             .material = beam_material(in)});
  return body;
}

inline std::vector<double> bearing_places(const nlohmann::json& in) {
  std::vector<double> places;
  for (const double p : in.at("bearings_mm")) places.push_back(p * mm);
  return places;
}

}  // namespace raceway::spindle::test
