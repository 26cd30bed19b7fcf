#pragma once

#include <memory>

#include "model/model.h"

namespace raceway::spindle {

/// The spindle that the coupled cases of data/reference/spindle_reference.json name.
inline model::Model base_spindle(double preload = 300.0, double f0 = 0.6) {
  using namespace raceway::model;
  const bearing::BearingGeometry geometry{.ball_count = 20,
                                          .ball_diameter = 11.9 * mm,
                                          .pitch_diameter = 90 * mm,
                                          .contact_angle = 15 * degree,
                                          .inner_conformity = 0.52,
                                          .outer_conformity = 0.52,
                                          .bore = 70 * mm,
                                          .outer_diameter = 110 * mm,
                                          .static_load_rating = 45000.0};
  const auto bearing =
      std::make_shared<const bearing::Bearing>(geometry, bearing::steel(), bearing::steel());
  Model m{.name = "base spindle",
          .bearing = *bearing,
          .lubricant = friction::Lubricant(20.0 * mm2_per_s, 4.4 * mm2_per_s),
          .law_values = {f0, 0.0007, 0.33},
          .effects = {},
          .solver = {},
          .rig = {},
          .free = {}};
  m.f1_load = friction::F1Load::F_b;
  bearing::ArrangementDesign design;
  design.front = {{bearing}, {bearing}};
  design.rear = {{bearing}};
  design.preload = bearing::PreloadForce{preload};
  design.distance = 215 * mm;
  m.shaft = Shaft{.arrangement = bearing::Arrangement(design)};
  Spindle s;
  s.front_positions = {60 * mm, 90 * mm};
  s.rear_positions = {290 * mm};
  s.bearing_width = 20 * mm;
  s.inner_ring_shoulder = 82 * mm;
  s.outer_ring_shoulder = 98 * mm;
  s.lubricant_conductance = 1.5;
  s.inner_heat_share = 0.5;
  const auto piece = [](double length, double diameter) {
    return Segment{.length = length * mm, .diameter = diameter * mm, .bore = 36 * mm};
  };
  s.shaft.segments = {piece(50, 104), piece(50, 70), piece(180, 82), piece(20, 70), piece(75, 60)};
  s.housing.start = 40 * mm;
  s.housing.segments = {
      {.length = 275 * mm, .diameter = 180 * mm, .bore = unset, .material = iron_of_housings}};
  s.housing.flange = 120 * mm;
  s.coolant = Coolant{.flow = 2.0 / 60000.0,
                      .inlet_temperature = kelvin(20),
                      .diameter = 140 * mm,
                      .channel_width = 10 * mm,
                      .channel_depth = 4 * mm,
                      .pitch = 14 * mm,
                      .start = 60 * mm,
                      .end = 300 * mm};
  m.spindle = s;
  return m;
}

/// The base spindle with two circuits, each around half of its housing.
inline model::Model two_circuits() {
  model::Model m = base_spindle();
  model::Coolant& first = *m.spindle->coolant;
  model::Coolant second = first;
  first.end = second.start = 0.5 * (first.start + first.end);
  second.inlet_temperature = unset;
  m.spindle->circuits = {{.name = "rear_jacket", .channel = second}};
  return m;
}

}  // namespace raceway::spindle
