#pragma once

#include <cmath>

#include "bearing/ball_equilibrium.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/lanes.h"

namespace raceway::bearing {

/// Results of a ball in equilibrium. The members are explained in BallEquilibrium.
template <typename T>
struct BallReport {
  T inner_contact_angle, outer_contact_angle;
  T inner_load, outer_load;
  T inner_friction, outer_friction;
  T centrifugal_force, gyroscopic_moment;
};

/// Returns the results of a ball in equilibrium. `a` is the inner groove centre, and `x` is the
/// ball centre. If `at_rest` is true, `x` is not used.
template <bool at_rest, typename T>
[[nodiscard, gnu::always_inline]] inline BallReport<T> ball_report(const BallForcesOf<T>& f,
                                                                   const PlaneOf<T>& a,
                                                                   const PlaneOf<T>& x,
                                                                   const T& ball_diameter) {
  using std::atan2;
  const T zero(0.0), lost(unset);
  const Mask<T> touches = f.inner_load > zero;
  BallReport<T> b;
  if constexpr (at_rest) {
    b.inner_contact_angle = b.outer_contact_angle = select(touches, atan2(a.axial, a.radial), lost);
  } else {
    b.outer_contact_angle = atan2(x.axial, x.radial);
    b.inner_contact_angle = select(touches, atan2(a.axial - x.axial, a.radial - x.radial), lost);
  }
  b.inner_load = f.inner_load;
  b.outer_load = f.outer_load;
  b.inner_friction = f.inner_friction;
  b.outer_friction = f.outer_friction;
  b.centrifugal_force = f.centrifugal;
  b.gyroscopic_moment = 0.5 * (f.inner_friction + f.outer_friction) * ball_diameter;
  return b;
}

[[nodiscard]] inline BallEquilibrium ball_equilibrium(const BallReport<double>& b, double azimuth) {
  return {.azimuth = azimuth,
          .inner_contact_angle = b.inner_contact_angle,
          .outer_contact_angle = b.outer_contact_angle,
          .inner_load = b.inner_load,
          .outer_load = b.outer_load,
          .inner_friction = b.inner_friction,
          .outer_friction = b.outer_friction,
          .centrifugal_force = b.centrifugal_force,
          .gyroscopic_moment = b.gyroscopic_moment};
}

}  // namespace raceway::bearing
