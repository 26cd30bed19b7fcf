#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "bench/robustness_domain.h"
#include "friction/contact/contact_friction.h"
#include "tests/bearing/random_case.h"

namespace raceway::friction::contact {

/// A bearing that runs: everything that its torque follows from.
struct RunningState {
  bearing::Bearing bearing;
  bearing::OperatingPoint point;
  Lubricant lubricant;
  OilData oil;
  ContactLaw law;

  [[nodiscard]] OilState oil_there() const { return oil_state(lubricant, oil, point.temperature); }
  [[nodiscard]] bearing::BearingEquilibrium balance() const {
    return solve_bearing_equilibrium(bearing, point);
  }
};

/// State number `index`, the same on every machine.
///   sizes of data/reference/gmn_sizes.csv with steel or ceramic balls, contact angle 12 to 60 deg,
///   conformities 0.51 to 0.54; 10 rpm to n d_m = 2.5e6 rpm mm, axial load 0.0005 to 0.3 C0, with
///   radial load up to half of it in every second, 10 to 100 °C; oils of all kinds from 5 to 220
///   mm²/s at 40 °C; flooded and limited inlets, with and without K_rs (bath, jet, grease and
///   oil-air) and inlet_over_b; composite roughness 0.02 to 0.5 um. Speeds, loads, oils and
///   roughness uniform in their logarithms.
inline RunningState running_state(std::uint64_t index) {
  static const std::vector<robustness::Size> sizes = tests::catalogue_sizes();
  std::uint64_t seed = 0x9e3779b97f4a7c15ULL + index * 0xd1342543de82ef95ULL;
  const auto uniform = [&](double low, double high) {
    return robustness::uniform_number(seed, low, high);
  };
  const auto spread = [&](double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  };
  const auto one_in = [&](double n) { return uniform(0.0, n) < 1.0; };
  const auto& size = sizes[std::min(
      static_cast<std::size_t>(uniform(0.0, static_cast<double>(sizes.size()))), sizes.size() - 1)];
  RunningState s{{{.ball_count = size.ball_count,
                   .ball_diameter = size.ball_diameter,
                   .pitch_diameter = size.pitch_diameter,
                   .contact_angle = uniform(12.0, 60.0) * degree,
                   .inner_conformity = uniform(0.51, 0.54),
                   .outer_conformity = uniform(0.51, 0.54)},
                  one_in(2) ? bearing::silicon_nitride() : bearing::steel(),
                  bearing::steel()},
                 {},
                 {22 * mm2_per_s, 4.8 * mm2_per_s},
                 {},
                 {}};
  s.point.speed = spread(10.0, 2.5e6 / (size.pitch_diameter / mm)) * rpm;
  s.point.axial_load = size.static_load_rating * spread(0.0005, 0.3);
  if (one_in(2)) s.point.radial_load = s.point.axial_load * uniform(0.0, 0.5);
  s.point.temperature = kelvin(uniform(10.0, 100.0));
  const double nu40 = spread(5.0, 220.0);
  s.lubricant = Lubricant(nu40 * mm2_per_s, std::pow(nu40, 0.5 + uniform(-0.03, 0.03)) * mm2_per_s);
  s.oil.type = one_in(3) ? OilType::mineral : one_in(2) ? OilType::pao : OilType::ester;
  s.law.supply = one_in(4) ? Inlet::flooded : Inlet::limited;
  s.law.replenishment = one_in(2) ? 0.0 : one_in(2) ? 3e-8 : 6e-8;
  if (one_in(4)) s.law.inlet_over_b = spread(1.05, 100.0);
  s.law.composite_roughness = spread(0.02, 0.5) * um;
  return s;
}

}  // namespace raceway::friction::contact
