#pragma once

#include "tests/spindle_study/machine.h"

namespace spindle_study {

/// The spindle that data/reference/spindle_reference.json calls spindle_base.toml.
inline Spindle base_spindle() {
  Spindle s;
  s.bearing = {.ball_diameter = 11.9e-3,
               .pitch_diameter = 90e-3,
               .ball_count = 20,
               .contact_angle = 15.0 * pi / 180.0,
               .inner_conformity = 0.52,
               .outer_conformity = 0.52,
               .static_rating = 45000.0};
  s.bearing_bore = 0.07;
  s.bearing_outer = 0.11;
  s.bearing_width = 0.02;
  s.inner_shoulder = 0.082;
  s.outer_shoulder = 0.098;
  s.front = {0.06, 0.09};
  s.rear = {0.29};
  s.preload = 300.0;
  s.f0 = 0.6;
  s.shaft_bore = 0.036;
  s.shaft = {{0.05, 0.104}, {0.05, 0.07}, {0.18, 0.082}, {0.02, 0.07}, {0.075, 0.06}};
  s.housing_start = 0.04;
  s.housing_length = 0.275;
  s.housing_diameter = 0.18;
  s.flange = 0.12;
  s.helix = {.flow = 2e-3 / 60.0,
             .inlet = 293.15,
             .diameter = 0.14,
             .width = 0.01,
             .depth = 0.004,
             .pitch = 0.014,
             .start = 0.06,
             .end = 0.3};
  return s;
}

}  // namespace spindle_study
