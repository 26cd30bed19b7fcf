#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "bearing/bearing_equilibrium.h"

/// Random loads on real spindle bearings, for which the solver must work.
namespace raceway::robustness {

/// Balls, pitch diameter and load rating of one catalogue bearing.
struct Size {
  int ball_count;
  double ball_diameter, pitch_diameter;  ///< [m]
  double static_load_rating;             ///< [N]
};

struct Case {
  bearing::BearingGeometry geometry;
  bearing::OperatingPoint point;
  bearing::EquilibriumOptions options;
  double rating = unset;  ///< C0 of the size [N]
};

/// Returns the next number of a SplitMix64 generator, which needs no warm-up.
inline double uniform_number(std::uint64_t& state, double lower, double upper) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  z ^= z >> 31;
  return lower + (upper - lower) * static_cast<double>(z >> 11) * 0x1.0p-53;
}

/// Returns case number `index` of a seed; equal on every machine and for any number of threads. The
/// contact angle is 12 to 25 deg, the conformities are 0.51 to 0.54, and n d_m is up to 3e6 rpm mm.
/// The axial load is 0.0005 to 0.5 C0, uniform in its logarithm. The radial load is 0 to 0.8 times
/// the axial load, in a third of the cases in any direction, otherwise along y. The tilt is locked
/// or free.
inline Case make_case(const std::vector<Size>& sizes, bearing::RaceControl race_control,
                      std::uint64_t seed, std::uint64_t index) {
  std::uint64_t state = seed * 0x9e3779b97f4a7c15ULL + index * 0xd1342543de82ef95ULL;
  const auto uniform = [&state](double lower, double upper) {
    return uniform_number(state, lower, upper);
  };
  const auto chosen = static_cast<std::size_t>(uniform(0.0, static_cast<double>(sizes.size())));
  const Size& size = sizes[std::min(chosen, sizes.size() - 1)];
  Case c;
  c.geometry.ball_count = size.ball_count;
  c.geometry.ball_diameter = size.ball_diameter;
  c.geometry.pitch_diameter = size.pitch_diameter;
  c.geometry.contact_angle = uniform(12.0, 25.0) * degree;
  c.geometry.inner_conformity = uniform(0.51, 0.54);
  c.geometry.outer_conformity = uniform(0.51, 0.54);
  c.point.speed = uniform(0.0, 3e6) / (size.pitch_diameter / mm) * rpm;
  c.point.axial_load = size.static_load_rating * std::exp(uniform(std::log(0.0005), std::log(0.5)));
  const double radial = c.point.axial_load * uniform(0.0, 0.8);
  const double direction = uniform(0.0, 3.0) < 1.0 ? uniform(0.0, 2.0 * pi) : 0.0;
  c.point.radial_load = radial * std::cos(direction);
  c.point.radial_load_z = radial * std::sin(direction);
  c.options.tilt = uniform(0.0, 1.0) < 0.5 ? bearing::Tilt::locked : bearing::Tilt::free;
  c.options.race_control = race_control;
  c.rating = size.static_load_rating;
  return c;
}

}  // namespace raceway::robustness
