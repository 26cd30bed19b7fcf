#pragma once

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include "bearing/bearing_equilibrium.h"
#include "friction/state.h"

namespace raceway::tests {

/// A 7014-like spindle bearing; the geometry of most reference cases.
inline bearing::BearingGeometry spindle_geometry() {
  return {.ball_count = 18,
          .ball_diameter = 12.7 * mm,
          .pitch_diameter = 90 * mm,
          .contact_angle = 25 * degree,
          .inner_conformity = 0.525,
          .outer_conformity = 0.515,
          .static_load_rating = 43000};
}

inline bearing::Bearing spindle_bearing(const bearing::Material& balls = bearing::steel()) {
  return {spindle_geometry(), balls, bearing::steel()};
}

/// Speed, loads and viscosity as T, seeded by `seed(i, value)`; i counts in this order.
template <typename T, typename Seed>
friction::BearingState<T> state_of(const bearing::Bearing& bearing,
                                   const std::array<double, 4>& values, const Seed& seed) {
  friction::BearingState<T> s;
  s.bearing = &bearing;
  s.speed = seed(0, values[0]);
  s.axial_load = seed(1, values[1]);
  s.radial_load = seed(2, values[2]);
  s.kinematic_viscosity = seed(3, values[3]);
  return s;
}

/// State at a point of solved balance; the bearing and the equilibrium stay with the caller.
inline friction::BearingState<double> state_of(const bearing::Bearing& bearing,
                                               const bearing::BearingEquilibrium& equilibrium,
                                               const bearing::OperatingPoint& point,
                                               bearing::RaceControl control) {
  friction::BearingState<double> s;
  s.bearing = &bearing;
  s.equilibrium = &equilibrium;
  s.race_control = control;
  s.speed = point.speed;
  s.axial_load = point.axial_load;
  s.radial_load = std::hypot(point.radial_load, point.radial_load_z);
  s.temperature = point.temperature;
  s.kinematic_viscosity = 22 * mm2_per_s;
  return s;
}

/// Automatic derivatives of a law by the four inputs of its state and by its parameters, against
/// central differences. The law is called as law(state, parameters) with T = double and Jet; away
/// from kinks and zeros the differences are good to 1e-7.
template <std::size_t P, typename Law>
void expect_derivatives(const bearing::Bearing& bearing, const std::array<double, 4>& inputs,
                        const std::array<double, P>& parameters, const Law& law) {
  using Jet = ceres::Jet<double, 4 + P>;
  std::array<Jet, P> p;
  for (std::size_t i = 0; i < P; ++i) p[i] = Jet(parameters[i], static_cast<int>(4 + i));
  const Jet value =
      law(state_of<Jet>(bearing, inputs, [](int i, double v) { return Jet(v, i); }), p);

  const auto shifted = [&](std::size_t i, double step) {
    std::array<double, 4> x = inputs;
    std::array<double, P> q = parameters;
    (i < 4 ? x[i] : q[i - 4]) += step;
    return law(state_of<double>(bearing, x, [](int, double v) { return v; }), q);
  };
  EXPECT_EQ(value.a, shifted(0, 0.0));
  for (std::size_t i = 0; i < 4 + P; ++i) {
    const double x = i < 4 ? inputs[i] : parameters[i - 4];
    const double step = 1e-5 * (x != 0.0 ? std::abs(x) : 1.0);
    const double difference = (shifted(i, step) - shifted(i, -step)) / (2.0 * step);
    EXPECT_NEAR(value.v[static_cast<int>(i)] * step, difference * step,
                1e-7 * std::max(std::abs(difference * step), 1e-4 * std::abs(value.a)))
        << "input " << i;
  }
}

/// Value and all derivatives are finite where a law has its edges: standstill, no load.
template <std::size_t P, typename Law>
void expect_finite_at_the_edges(const bearing::Bearing& bearing,
                                const std::array<double, P>& parameters, const Law& law) {
  using Jet = ceres::Jet<double, 4 + P>;
  std::array<Jet, P> p;
  for (std::size_t i = 0; i < P; ++i) p[i] = Jet(parameters[i], static_cast<int>(4 + i));
  for (const double speed : {0.0, 1000 * rpm})
    for (const double axial : {0.0, 500.0})
      for (const double radial : {0.0, 200.0}) {
        SCOPED_TRACE(testing::Message()
                     << speed << " rad/s, " << axial << " N, " << radial << " N");
        const Jet m = law(state_of<Jet>(bearing, {speed, axial, radial, 22 * mm2_per_s},
                                        [](int i, double v) { return Jet(v, i); }),
                          p);
        EXPECT_TRUE(std::isfinite(m.a));
        EXPECT_GE(m.a, 0.0);
        EXPECT_TRUE(m.v.allFinite()) << m.v.transpose();
      }
}

inline void expect_relative(double value, double reference, double relative_tolerance) {
  EXPECT_NEAR(value, reference, relative_tolerance * std::abs(reference));
}

/// The message with which something is refused; empty where it is not.
inline std::string message_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

}  // namespace raceway::tests
