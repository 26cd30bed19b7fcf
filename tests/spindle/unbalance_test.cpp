#include "spindle/unbalance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "record/units.h"
#include "spindle/modes.h"

namespace raceway::spindle {
namespace {

/// The shaft bends by 2e-7 of its springs and weighs 5e-7 of its disk; near the mode a small
/// damping raises both.
constexpr double jeffcott_tolerance = 2e-5;
constexpr double rotor_mass = 1000.0, jeffcott_stiffness = 100.0;  // [kg], [N/m] of both springs

/// A disk in the middle of a thin tube that hardly weighs or bends, on a spring at each end: the
/// rotor of Jeffcott.
struct Jeffcott {
  model::ShaftBody body;
  std::vector<double> ends{0.0, 0.4};
  explicit Jeffcott(double elastic_modulus = 1e13) {
    model::SolidMaterial m;
    m.elastic_modulus = elastic_modulus;
    m.poissons_ratio = 0.3;
    m.density = 10.0;
    body.segments = {{.length = 0.4, .diameter = 0.08, .bore = 0.079, .material = m}};
    body.disks = {
        {.position = 0.2, .mass = rotor_mass, .diametral_inertia = 5.0, .polar_inertia = 8.0}};
  }
  [[nodiscard]] Beam beam() const { return Beam(body, ends, {.element_length = 0.1}); }
};

std::vector<Spring> jeffcott_springs(double y = jeffcott_stiffness, double z = jeffcott_stiffness) {
  std::vector<Spring> list;
  for (const double place : {0.0, 0.4}) {
    Spring s = isotropic_spring(place, 0.5 * y);
    s.z.radial = 0.5 * z;
    list.push_back(s);
  }
  return list;
}

TEST(Unbalance, OfARigidRotorIsThatOfJeffcott) {
  const Beam beam = Jeffcott().beam();
  const double zeta = 0.03, size = 5e-5, own = std::sqrt(jeffcott_stiffness / rotor_mass);
  for (const double ratio : {0.2, 0.9, 1.0, 1.1, 3.0}) {
    const double speed = ratio * own;
    const std::complex<double> wanted =
        size * speed * speed /
        (rotor_mass * (own * own * std::complex<double>(1.0, 2.0 * zeta) - speed * speed));
    const Orbit orbit =
        unbalance_orbit(beam, jeffcott_springs(), speed,
                        {.size = size, .position = 0.2, .damping_ratio = zeta}, 0.2);
    EXPECT_NEAR(orbit.amplitude, std::abs(wanted), jeffcott_tolerance * std::abs(wanted)) << ratio;
    EXPECT_NEAR(orbit.lag, -std::arg(wanted), jeffcott_tolerance) << ratio;
  }
  // Where the mode is met, u/m is raised 1/(2 ζ) times, a quarter of a turn behind.
  const Orbit met = unbalance_orbit(beam, jeffcott_springs(), own,
                                    {.size = size, .position = 0.2, .damping_ratio = zeta}, 0.2);
  EXPECT_NEAR(met.amplitude, size / rotor_mass / (2.0 * zeta), jeffcott_tolerance * met.amplitude);
  EXPECT_NEAR(met.lag, 0.5 * pi, jeffcott_tolerance);
}

TEST(Unbalance, OfUnequalPlanesIsThatOfEachPlane) {
  const Beam beam = Jeffcott().beam();
  const double zeta = 0.02, size = 5e-5, ky = jeffcott_stiffness, kz = 2.0 * jeffcott_stiffness;
  const double speed = std::sqrt(1.4 * jeffcott_stiffness / rotor_mass);
  const auto plane = [&](double k) {
    return size * speed * speed /
           (k * std::complex<double>(1.0, 2.0 * zeta) - rotor_mass * speed * speed);
  };
  const std::complex<double> i(0.0, 1.0), v = plane(ky), w = -i * plane(kz);
  const double wanted = 0.5 * (std::abs(v + i * w) + std::abs(std::conj(v) + i * std::conj(w)));
  const Orbit orbit = unbalance_orbit(beam, jeffcott_springs(ky, kz), speed,
                                      {.size = size, .position = 0.2, .damping_ratio = zeta}, 0.2);
  EXPECT_NEAR(orbit.amplitude, wanted, jeffcott_tolerance * wanted);
}

TEST(Unbalance, IsLargestWhereOncePerTurnMeetsAForwardMode) {
  // A shaft that bends, its disk off the middle: the gyroscopic moment moves the mode.
  Jeffcott rotor(210e9);
  constexpr double mass = 10.0, stiffness = 1e8;
  rotor.body.segments[0].bore = 0.0;
  rotor.body.disks = {
      {.position = 0.3, .mass = mass, .diametral_inertia = 0.05, .polar_inertia = 0.03}};
  const std::vector<Spring> springs = jeffcott_springs(stiffness, stiffness);
  const Beam beam(rotor.body, rotor.ends, {.element_length = 0.1});
  // The forward mode at its own speed, by iteration.
  double critical = std::sqrt(stiffness / mass);
  for (int k = 0; k < 40; ++k)
    for (const Mode& m : find_modes(beam, springs, critical).modes)
      if (m.whirl == Whirl::forward) {
        critical = m.frequency;
        break;
      }
  const Unbalance unbalance{.size = 1e-5, .position = 0.1, .damping_ratio = 0.002};
  const auto nose = [&](double speed) {
    return unbalance_orbit(beam, springs, speed, unbalance).amplitude;
  };
  double best = 0.0, at = 0.0;
  for (double share = 0.97; share < 1.03; share += 2e-4)
    if (nose(share * critical) > best) best = nose(share * critical), at = share;
  EXPECT_NEAR(at, 1.0, 4e-4);
  EXPECT_GT(best, 10.0 * nose(0.9 * critical));
}

TEST(Unbalance, MovesNothingAtRestAndAFreeRotorAboutItsCentreOfMass) {
  const Beam beam = Jeffcott().beam();
  const Unbalance unbalance{.size = 5e-5, .position = 0.2, .damping_ratio = 0.02};
  const Orbit still = unbalance_orbit(beam, jeffcott_springs(), 0.0, unbalance, 0.2);
  EXPECT_EQ(still.amplitude, 0.0);
  EXPECT_TRUE(std::isnan(still.lag));
  // Far above its mode the axis runs at u/m about the centre of mass.
  const double fast = 50.0 * std::sqrt(jeffcott_stiffness / rotor_mass);
  EXPECT_NEAR(unbalance_orbit(beam, jeffcott_springs(), fast, unbalance, 0.2).amplitude,
              unbalance.size / rotor_mass, 1e-3 * unbalance.size / rotor_mass);
}

}  // namespace
}  // namespace raceway::spindle
