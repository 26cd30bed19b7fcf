#pragma once

#include <nlohmann/json.hpp>

#include "bearing/bearing.h"

namespace raceway::friction::contact {

/// The bearing that a case of data/reference/contact_reference.json names under `geometry`.
inline bearing::Bearing reference_bearing(const nlohmann::json& g, const bearing::Material& balls) {
  return {{.ball_count = g.at("Z"),
           .ball_diameter = g.at("D"),
           .pitch_diameter = g.at("dm"),
           .contact_angle = g.at("alpha0").get<double>() * degree,
           .inner_conformity = g.at("fi"),
           .outer_conformity = g.at("fo")},
          balls,
          bearing::steel()};
}

}  // namespace raceway::friction::contact
