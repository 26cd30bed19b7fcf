#include "spindle/modes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/spindle/beam_cases.h"

namespace raceway::spindle {
namespace {

using nlohmann::json;
using test::beam_case;
using test::beam_material;
using test::bearing_places;
using test::spindle_shaft;

void expect_modes(const Modes& found, const json& expected, double unit, double tolerance) {
  ASSERT_TRUE(found.converged());
  ASSERT_EQ(found.modes.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double e = expected.at(i);
    EXPECT_NEAR(found.modes[i].frequency / unit, e, tolerance * e) << i;
  }
}

constexpr double hertz = 2.0 * pi;

/// A shaft with two disks on springs at both ends, of the example 5.9 in Friswell et al. 2010.
struct Rotor {
  model::ShaftBody body;
  std::vector<double> ends{0.0, 1.5};
  BeamMesh mesh;

  explicit Rotor(int elements) {
    model::SolidMaterial m;
    m.elastic_modulus = 211e9;
    m.poissons_ratio = 211e9 / (2.0 * 81.2e9) - 1.0;
    m.density = 7810;
    body.segments = {{.length = 1.5, .diameter = 0.05, .bore = 0.0, .material = m}};
    const double thickness = 0.07, bore = 0.05;
    for (const auto& [place, diameter] : {std::pair{0.5, 0.28}, std::pair{1.0, 0.35}}) {
      const double squares = 0.25 * (diameter * diameter + bore * bore);
      const double mass = m.density * thickness * 0.25 * pi * (diameter * diameter - bore * bore);
      body.disks.push_back(
          {.position = place,
           .mass = mass,
           .diametral_inertia = mass / 12.0 * (3.0 * squares + thickness * thickness),
           .polar_inertia = 0.5 * mass * squares});
    }
    mesh.element_length = 1.5 / elements;
  }
};

TEST(Modes, RotorOnTwoSpringsIsThatOfTheBook) {
  for (const json& c : references("friswell_")) {
    const json& in = c.at("inputs");
    const Rotor rotor(in.value("elements", 6));
    const Beam beam(rotor.body, rotor.ends, rotor.mesh);
    std::vector<Spring> springs;
    for (const double end : rotor.ends)
      springs.push_back(
          {.position = end, .y = {.radial = in.at("ky")}, .z = {.radial = in.at("kz")}});
    const json& omega = c.at("outputs").at("omega");
    expect_modes(
        find_modes(beam, springs, in.at("rpm").get<double>() * rpm, static_cast<int>(omega.size())),
        omega, 1.0, c.at("tolerance_rel"));
  }
}

TEST(Modes, AnisotropicFormEqualsTheIsotropicOneForEqualSprings) {
  const Rotor rotor(12);
  const Beam beam(rotor.body, rotor.ends, rotor.mesh);
  std::vector<Spring> equal, unequal;
  for (const double end : rotor.ends) {
    equal.push_back(isotropic_spring(end, 1e6));
    unequal.push_back(equal.back());
    unequal.back().z.radial *= 1.0 + 1e-12;
  }
  const Modes one = find_modes(beam, equal, 4000 * rpm),
              two = find_modes(beam, unequal, 4000 * rpm);
  ASSERT_TRUE(one.converged() && two.converged());
  for (std::size_t i = 0; i < one.modes.size(); ++i) {
    EXPECT_NEAR(one.modes[i].frequency, two.modes[i].frequency, 1e-9 * one.modes[i].frequency);
    EXPECT_EQ(one.modes[i].whirl, two.modes[i].whirl);
    EXPECT_LT((one.modes[i].y - two.modes[i].y).lpNorm<Eigen::Infinity>(), 1e-5);
    EXPECT_LT((one.modes[i].z - two.modes[i].z).lpNorm<Eigen::Infinity>(), 1e-5);
  }
}

TEST(Modes, WhirlOfTheModesSolvesTheEquationsOfMotion) {
  const Rotor rotor(12);
  const Beam beam(rotor.body, rotor.ends, rotor.mesh);
  std::vector<PlaneSpring> in_y{{.radial = 1e6}, {.radial = 1e6}},
      in_z{{.radial = 8e5}, {.radial = 8e5}};
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < 2; ++i)
    springs.push_back({.position = rotor.ends[i], .y = in_y[i], .z = in_z[i]});
  const double speed = 4000 * rpm;
  const auto ky = beam.held_by(rotor.ends, in_y), kz = beam.held_by(rotor.ends, in_z);
  const Modes found = find_modes(beam, springs, speed);
  ASSERT_TRUE(found.converged());
  for (const Mode& m : found.modes) {
    // v_y = y cos ωt, v_z = z sin ωt in M v_y'' + Ω G v_z' + K_y v_y = 0 and
    // M v_z'' - Ω G v_y' + K_z v_z = 0.
    const double w = m.frequency;
    const Eigen::VectorXd ky_y = ky * m.y;
    const Eigen::VectorXd along_y =
        -w * w * (beam.mass() * m.y) + speed * w * (beam.gyroscopic() * m.z) + ky_y;
    const Eigen::VectorXd along_z =
        -w * w * (beam.mass() * m.z) + speed * w * (beam.gyroscopic() * m.y) + kz * m.z;
    const double force = w * w * (beam.mass() * m.y).norm() + w * w * (beam.mass() * m.z).norm();
    EXPECT_LT(along_y.norm(), 1e-6 * force);
    EXPECT_LT(along_z.norm(), 1e-6 * force);
  }
}

TEST(Modes, PinnedBeamHasThoseOfTheClosedForm) {
  for (const json& c : references("pinned_beam")) {
    const json& in = c.at("inputs");
    const double length = in.at("L_m");
    const model::ShaftBody body{.segments = {{.length = length,
                                              .diameter = in.at("d_m"),
                                              .bore = 0.0,
                                              .material = beam_material(in)}}};
    const double ends[] = {0.0, length};
    const Beam beam(body, ends, {.elements = 100});
    EXPECT_EQ(beam.elements(), 100u);
    const std::vector<Spring> springs{isotropic_spring(0.0, 1e13), isotropic_spring(length, 1e13)};
    const json& expected = c.at("outputs").at("f_Hz");
    const Modes found = find_modes(beam, springs, in.at("rpm").get<double>() * rpm,
                                   2 * static_cast<int>(expected.size()));
    ASSERT_GE(found.modes.size(), 2 * expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      for (const std::size_t twin : {2 * i, 2 * i + 1})
        EXPECT_NEAR(found.modes[twin].frequency / hertz, expected.at(i).get<double>(),
                    c.at("tolerance_rel").get<double>() * expected.at(i).get<double>());
  }
}

TEST(Modes, SpindleHasThoseOfTheReference) {
  for (const json& c : references("spindle_modes_")) {
    const json& in = c.at("inputs");
    const std::vector<double> places = bearing_places(in);
    model::ShaftBody body = spindle_shaft(in);
    if (in.contains("disk_at_end")) {
      const json& d = in.at("disk_at_end");
      body.disks.push_back({.position = 375 * mm,
                            .mass = d.at("mass_kg"),
                            .diametral_inertia = d.at("Id_kgm2"),
                            .polar_inertia = d.at("Ip_kgm2")});
    }
    const Beam beam(body, places, {.element_length = in.at("element_mm").get<double>() * mm});
    std::vector<Spring> springs;
    for (std::size_t i = 0; i < places.size(); ++i)
      springs.push_back(isotropic_spring(
          places[i], in.at("radial_N_m").at(i),
          in.contains("tilt_Nm_rad") ? in["tilt_Nm_rad"].at(i).get<double>() : 0.0));
    for (const int speed : in.at("rpm")) {
      const json& expected = c.at("outputs").at("f_Hz_" + std::to_string(speed));
      const Modes found = find_modes(beam, springs, speed * rpm, static_cast<int>(expected.size()));
      expect_modes(found, expected, hertz, c.at("tolerance_rel"));
      for (std::size_t i = 0; i < found.modes.size(); ++i)
        EXPECT_EQ(found.modes[i].whirl, speed == 0   ? Whirl::standing
                                        : i % 2 == 0 ? Whirl::backward
                                                     : Whirl::forward);
    }
  }
}

TEST(Modes, SupportsOfTheShaftAreSprings) {
  const json c = beam_case("spindle_modes_0"), &in = c.at("inputs");
  model::ShaftBody body = spindle_shaft(in);
  std::vector<Spring> springs;
  for (const double p : bearing_places(in)) {
    body.supports.push_back({.position = p, .radial_stiffness = 1.2e8, .tilt_stiffness = 3e4});
    springs.push_back(isotropic_spring(p, 1.2e8, 3e4));
  }
  const Modes one = find_modes(Beam(body, {}), {}, 5000 * rpm);
  const Modes other = find_modes(Beam(spindle_shaft(in), bearing_places(in)), springs, 5000 * rpm);
  ASSERT_TRUE(one.converged() && other.converged());
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(one.modes[i].frequency, other.modes[i].frequency, 1e-9 * one.modes[i].frequency);
}

TEST(Modes, AShaftThatNothingHoldsIsSaidToBeSo) {
  const json c = beam_case("spindle_modes_0");
  const Beam beam(spindle_shaft(c.at("inputs")), {});
  EXPECT_FALSE(find_modes(beam, {}, 0.0).converged());
}

}  // namespace
}  // namespace raceway::spindle
