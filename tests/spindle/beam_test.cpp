#include "spindle/beam.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "tests/spindle/beam_cases.h"

namespace raceway::spindle {
namespace {

using nlohmann::json;
using test::beam_case;
using test::beam_material;
using test::bearing_places;
using test::spindle_shaft;

void expect_of_beam(double value, const json& expected, const json& c) {
  EXPECT_NEAR(value, expected.get<double>(),
              c.at("tolerance_rel").get<double>() * std::abs(expected.get<double>()));
}

model::ShaftBody bar(const json& in, double length) {
  return {.segments = {{.length = length,
                        .diameter = in.at("d_m"),
                        .bore = 0.0,
                        .material = beam_material(in)}}};
}

TEST(Beam, ElementIsThatOfAnotherProgram) {
  for (const json& c : references("beam_element_")) {
    const json &in = c.at("inputs"), &out = c.at("outputs");
    const model::SolidMaterial material = beam_material(in);
    const BeamElement e{.length = in.at("L_m"),
                        .outer_diameter = in.at("d_m"),
                        .bore = 0.0,
                        .elastic_modulus = material.elastic_modulus,
                        .poissons_ratio = material.poissons_ratio,
                        .density = material.density};
    const ElementMatrices m = element_matrices(e);
    expect_of_beam(e.shear_ratio(), out.at("phi"), c);
    expect_of_beam(m.stiffness(0, 0), out.at("K11"), c);
    expect_of_beam(m.stiffness(0, 1), out.at("K12"), c);
    expect_of_beam(m.stiffness(1, 1), out.at("K22"), c);
    expect_of_beam(m.mass(0, 0), out.at("M11"), c);
    expect_of_beam(m.mass(0, 1), out.at("M12"), c);
    expect_of_beam(m.gyroscopic(0, 0), out.at("gyro11"), c);
    expect_of_beam(m.gyroscopic(1, 1), out.at("gyro22"), c);
  }
}

TEST(Beam, ElementStoresNothingInRigidMotionAndHasItsMass) {
  const BeamElement e{.length = 0.03,
                      .outer_diameter = 0.08,
                      .bore = 0.03,
                      .elastic_modulus = 200e9,
                      .poissons_ratio = 0.29,
                      .density = 7800};
  const ElementMatrices m = element_matrices(e);
  const Eigen::Vector4d shifted(1.0, 0.0, 1.0, 0.0), turned(0.0, 1.0, e.length, 1.0);
  const double mass = e.density * e.area() * e.length;
  EXPECT_LT((m.stiffness * shifted).norm(), 1e-9 * m.stiffness.norm());
  EXPECT_LT((m.stiffness * turned).norm(), 1e-9 * m.stiffness.norm());
  EXPECT_NEAR(shifted.dot(m.mass * shifted), mass, 1e-12 * mass);
  const double about_end =
      mass * e.length * e.length / 3.0 + e.density * e.second_moment() * e.length;
  EXPECT_NEAR(turned.dot(m.mass * turned), about_end, 1e-12 * about_end);
  const double polar = 2.0 * e.density * e.second_moment() * e.length;
  EXPECT_NEAR(turned.dot(m.gyroscopic * turned), polar, 1e-12 * polar);
}

TEST(Beam, CantileverBendsAsTheClosedFormSays) {
  for (const json& c : references("cantilever")) {
    const json& in = c.at("inputs");
    const double length = in.at("L_m");
    const Beam beam(bar(in, length), {});
    const double end[] = {length};
    // So stiff that the end does not move by a digit that is asked for, and the matrix keeps its
    // own.
    const PlaneSpring clamp[] = {{.radial = 1e17, .tilt = 1e15}};
    const BeamLoad load[] = {{.position = 0.0, .force = in.at("force_N")}};
    const Deflection d = deflect(beam, end, clamp, load);
    ASSERT_TRUE(d.found);
    expect_of_beam(d.shape[0], c.at("outputs").at("tip_m"), c);
  }
}

TEST(Beam, OverhungNoseIsExactAtNodesForAnyMesh) {
  for (const json& c : references("overhung_nose_")) {
    const json& in = c.at("inputs");
    const double a = in.at("overhang_m"), span = in.at("span_m");
    const double places[] = {a, a + span};
    const PlaneSpring springs[] = {{.radial = in.at("k_front_N_m")},
                                   {.radial = in.at("k_rear_N_m")}};
    const BeamLoad load[] = {{.position = 0.0, .force = in.at("force_N")}};
    for (const double element : {5 * mm, 60 * mm, 1.0}) {
      const Beam beam(bar(in, a + span), places, {.element_length = element});
      const Deflection d = deflect(beam, places, springs, load);
      ASSERT_TRUE(d.found);
      expect_of_beam(d.shape[0], c.at("outputs").at("nose_m"), c);
    }
  }
}

TEST(Beam, SpindleBendsAsTheReferenceDoes) {
  for (const json& c : references("spindle_deflection_")) {
    const json& in = c.at("inputs");
    const std::vector<double> places = bearing_places(in);
    const Beam beam(spindle_shaft(in), places,
                    {.element_length = in.at("element_mm").get<double>() * mm});
    std::vector<PlaneSpring> springs;
    for (std::size_t i = 0; i < places.size(); ++i)
      springs.push_back(
          {.radial = in.at("radial_N_m").at(i), .tilt = in.at("tilt_Nm_rad").at(i), .coupling = 0});
    const BeamLoad load[] = {{.position = 0.0, .force = in.at("force_N")}};
    const Deflection d = deflect(beam, places, springs, load);
    ASSERT_TRUE(d.found);
    expect_of_beam(d.shape[0] / um, c.at("outputs").at("nose_um"), c);
    expect_of_beam(d.shape[1] * 1e6, c.at("outputs").at("slope_urad"), c);
  }
}

TEST(Beam, DisplacementUnderALoadElsewhereIsTheSameTheOtherWayRound) {
  const json c = beam_case("spindle_deflection_0"), &in = c.at("inputs");
  const std::vector<double> places = bearing_places(in);
  const Beam beam(spindle_shaft(in), places);
  const std::vector<PlaneSpring> springs(3, {.radial = 1.5e8, .tilt = 2e4, .coupling = -1e6});
  const double one = 13.7 * mm, other = 211.1 * mm;
  const BeamLoad at_one[] = {{.position = one, .force = 1.0}};
  const BeamLoad at_other[] = {{.position = other, .moment = 1.0}};
  const Eigen::Vector2d here = beam.at(other, deflect(beam, places, springs, at_one).shape);
  const Eigen::Vector2d there = beam.at(one, deflect(beam, places, springs, at_other).shape);
  EXPECT_NEAR(here[1], there[0], 1e-8 * std::abs(here[1]));
}

TEST(Beam, CondensedItBendsAlikeEverywhere) {
  const json c = beam_case("spindle_deflection_0"), &in = c.at("inputs");
  const std::vector<double> places = bearing_places(in);
  const Beam beam(spindle_shaft(in), places);
  const std::vector<PlaneSpring> springs(3, {.radial = 1.5e8, .tilt = 2e4, .coupling = -1e6});
  const BeamLoad load[] = {{.position = 0.0, .force = 800.0, .moment = 20.0}};
  const Deflection d = deflect(beam, places, springs, load);
  const CondensedBeam few(
      beam, {0, beam.node_at(places[0]), beam.node_at(places[1]), beam.node_at(places[2])});
  Eigen::MatrixXd k = few.stiffness();
  for (int i = 0; i < 3; ++i) {
    const PlaneSpring& s = springs[static_cast<std::size_t>(i)];
    k.block<2, 2>(2 * i + 2, 2 * i + 2) +=
        (Eigen::Matrix2d() << s.radial, s.coupling, s.coupling, s.tilt).finished();
  }
  Eigen::VectorXd f = Eigen::VectorXd::Zero(8);
  f[0] = 800.0;
  f[1] = 20.0;
  const Eigen::VectorXd all = few.expand(k.ldlt().solve(f));
  EXPECT_LT((all - d.shape).lpNorm<Eigen::Infinity>(), 1e-7 * d.shape.lpNorm<Eigen::Infinity>());
}

TEST(Beam, AShaftThatNothingHoldsIsSaidToBeSo) {
  const json c = beam_case("spindle_deflection_0");
  const Beam beam(spindle_shaft(c.at("inputs")), {});
  const BeamLoad load[] = {{.position = 0.0, .force = 1.0}};
  EXPECT_FALSE(deflect(beam, {}, {}, load).found);
}

TEST(Beam, WrongShaftsAreRefused) {
  model::ShaftBody body{.segments = {{.length = 0.1, .diameter = 0.05, .bore = 0.06}}};
  EXPECT_THROW(Beam(body, {}), std::invalid_argument);
  body.segments[0].bore = 0.0;
  const double beyond[] = {0.2};
  EXPECT_THROW(Beam(body, beyond), std::invalid_argument);
  EXPECT_NO_THROW(Beam(body, {}));
}

}  // namespace
}  // namespace raceway::spindle
