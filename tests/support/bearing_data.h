#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "bearing/bearing.h"

namespace raceway::tests {

/// The bearing with each of its data changed, by the name of the datum as friction::bearing_data()
/// has it.
inline std::vector<std::pair<std::string_view, bearing::Bearing>> with_each_datum_changed(
    const bearing::Bearing& entered) {
  const bearing::BearingGeometry g = entered.geometry();
  const auto with = [&](auto&& change) {
    bearing::BearingGeometry other = g;
    change(other);
    return bearing::Bearing(other, entered.balls(), entered.rings());
  };
  using G = bearing::BearingGeometry;
  bearing::Material softer = bearing::steel();
  softer.elastic_modulus *= 0.9;
  softer.thermal_expansion *= 0.9;
  return {
      {"ball_count", with([](G& x) { x.ball_count -= 1; })},
      {"ball_diameter", with([](G& x) { x.ball_diameter *= 0.9; })},
      {"pitch_diameter", with([](G& x) { x.pitch_diameter *= 1.02; })},
      {"contact_angle", with([](G& x) { x.contact_angle *= 1.1; })},
      {"inner_conformity", with([](G& x) { x.inner_conformity += 0.01; })},
      {"outer_conformity", with([](G& x) { x.outer_conformity += 0.01; })},
      {"static_load_rating", with([](G& x) { x.static_load_rating *= 1.1; })},
      {"bore", with([](G& x) { x.bore *= 0.95; })},
      {"outer_diameter", with([](G& x) { x.outer_diameter *= 1.05; })},
      {"ball_material", bearing::Bearing(g, bearing::silicon_nitride(), entered.rings())},
      {"ring_material", bearing::Bearing(g, entered.balls(), softer)},
  };
}

}  // namespace raceway::tests
