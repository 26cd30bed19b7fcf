#include "spindle/loaded_shaft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "spindle/modes.h"
#include "tests/spindle/beam_cases.h"
#include "tests/spindle/case_bearing.h"

namespace raceway::spindle {
namespace {

using bearing::Arrangement;
using bearing::ArrangementCondition;
using bearing::Bearing;
using nlohmann::json;

std::shared_ptr<const Bearing> bearing_of_15_degrees() {
  static const auto one =
      std::make_shared<const Bearing>(bearing::BearingGeometry{.ball_count = 20,
                                                               .ball_diameter = 11.9 * mm,
                                                               .pitch_diameter = 90 * mm,
                                                               .contact_angle = 15 * degree,
                                                               .inner_conformity = 0.52,
                                                               .outer_conformity = 0.52},
                                      bearing::steel(), bearing::steel());
  return one;
}

Arrangement two_against_one(bearing::Layout layout) {
  const auto b = bearing_of_15_degrees();
  return Arrangement({.layout = layout,
                      .front = {{b}, {b}},
                      .rear = {{b}},
                      .preload = bearing::PreloadForce{300.0}});
}

struct BentSpindle {
  json in = test::beam_case("spindle_deflection_0").at("inputs");
  std::vector<double> places = test::bearing_places(in);
  Beam beam{test::spindle_shaft(in), places};
};

TEST(LoadedShaft, TangentStiffnessOfBearingsGivesTheModesOfTheReference) {
  for (const json& c : references("tangent_stiffness_modes_")) {
    const json &in = c.at("inputs"), &out = c.at("outputs");
    const double tolerance = c.at("tolerance_rel"), speed = in.at("rpm").get<double>() * rpm;
    const auto expect = [&](double value, const json& expected) {
      EXPECT_NEAR(value, expected.get<double>(), tolerance * std::abs(expected.get<double>()));
    };
    const auto e =
        solve_bearing_equilibrium(*case_bearing(in.at("bearing")),
                                  {.speed = speed, .axial_load = in.at("axial_load_each_N")});
    ASSERT_TRUE(e.report.converged());
    expect(e.stiffness(0, 0) * um, out.at("axial_N_um"));
    expect(e.stiffness(1, 1) * um, out.at("radial_N_um"));
    expect(e.stiffness(4, 4), out.at("tilt_Nm_rad"));
    expect(e.stiffness(1, 4), out.at("K_y_thetaz_N_rad"));
    expect(e.stiffness(4, 1), out.at("K_thetaz_y_Nm_m"));

    const std::vector<double> places = test::bearing_places(in);
    const Beam beam(test::spindle_shaft(in), places);
    const std::vector<bearing::BearingEquilibrium> three(3, e);
    const auto check = [&](bearing::Layout layout, const json& modes, double nose) {
      const std::vector<Spring> springs = bearing_springs(two_against_one(layout), places, three);
      const Modes found = find_modes(beam, springs, speed);
      ASSERT_TRUE(found.converged());
      for (std::size_t i = 0; i < modes.size(); ++i)
        expect(found.modes[i].frequency / (2.0 * pi), modes.at(i));
      std::vector<PlaneSpring> in_y;
      for (const Spring& s : springs) in_y.push_back(s.y);
      const BeamLoad load[] = {{.position = 0.0, .force = 1000.0}};
      expect(deflect(beam, places, in_y, load).shape[0] / um, nose);
    };
    check(bearing::Layout::back_to_back, out.at("modes_Hz"), out.at("nose_um_under_1000_N"));
    // The wrong sign of the coupling is the right one of an X.
    const json& wrong = out.at("if_coupling_sign_were_wrong");
    check(bearing::Layout::face_to_face, wrong.at("modes_Hz"), wrong.at("nose_um"));
  }
}

TEST(LoadedShaft, UnderAxialLoadAloneItIsTheArrangement) {
  const BentSpindle s;
  for (const auto layout : {bearing::Layout::back_to_back, bearing::Layout::face_to_face}) {
    const Arrangement set = two_against_one(layout);
    ArrangementCondition condition{
        .speed = 6000 * rpm, .external_load = 120.0, .elongation = 10 * um};
    condition.shifts = {{.radial = 4 * um}, {.radial = 5 * um}, {.radial = 6 * um}};
    const auto e = solve_arrangement(set, condition);
    ASSERT_TRUE(e.report.converged());
    condition.external_load = 20.0;
    const LoadedShaft bent = solve_loaded_shaft(s.beam, set, s.places, condition, {.axial = 100.0});
    ASSERT_TRUE(bent.report.converged());
    EXPECT_NEAR(bent.position, e.position, 1e-9 * um);
    EXPECT_NEAR(bent.front_force, e.front_force, 1e-5);
    EXPECT_NEAR(bent.rear_force, e.rear_force, 1e-5);
    EXPECT_LT(bent.y.norm(), 1e-15);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(bent.loads[i][0], e.bearings[i].axial_load, 1e-5);
  }
}

TEST(LoadedShaft, UnderATinyRadialForceItBendsByTheTangentStiffnesses) {
  const BentSpindle s;
  for (const auto layout : {bearing::Layout::back_to_back, bearing::Layout::face_to_face})
    for (const double speed : {0.0, 6000.0}) {
      const Arrangement set = two_against_one(layout);
      const ArrangementCondition condition{.speed = speed * rpm};
      const auto e = solve_arrangement(set, condition);
      ASSERT_TRUE(e.report.converged());
      const auto springs = bearing_springs(set, s.places, bearings_in_set(set, condition, e));
      std::vector<PlaneSpring> in_y;
      for (const Spring& spring : springs) in_y.push_back(spring.y);
      const double force = 0.1;
      const BeamLoad load[] = {{.position = 0.0, .force = force}};
      const Deflection linear = deflect(s.beam, s.places, in_y, load);
      const LoadedShaft bent =
          solve_loaded_shaft(s.beam, set, s.places, condition, {.radial = force});
      ASSERT_TRUE(bent.report.converged());
      // At speed the mean of the off-diagonals differs from them in the first digits after 1e-3.
      EXPECT_NEAR(bent.y[0], linear.shape[0], (speed == 0.0 ? 1e-5 : 1e-3) * linear.shape[0]);
      EXPECT_LT(bent.z.norm(), 1e-9 * bent.y.norm());
    }
}

TEST(LoadedShaft, BearingsCarryWhatIsApplied) {
  const BentSpindle s;
  const Arrangement set = two_against_one(bearing::Layout::back_to_back);
  const ArrangementCondition condition{.speed = 8000 * rpm};
  const ShaftLoad load{.position = 0.0,
                       .axial = -200.0,
                       .radial = 600.0,
                       .radial_z = -250.0,
                       .moment = 8.0,
                       .moment_z = 3.0};
  const LoadedShaft bent = solve_loaded_shaft(s.beam, set, s.places, condition, load);
  ASSERT_TRUE(bent.report.converged());
  double y = 0.0, z = 0.0, about_z = 0.0, about_y = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double side = presses_rearwards(set, i) ? 1.0 : -1.0;
    const bearing::Vector5& f = bent.loads[i];
    y += f[1];
    z += side * f[2];
    about_z += s.places[i] * f[1] + side * f[4];
    about_y += s.places[i] * side * f[2] - f[3];
  }
  EXPECT_NEAR(y, load.radial, 1e-5);
  EXPECT_NEAR(z, load.radial_z, 1e-5);
  EXPECT_NEAR(about_z, load.moment, 1e-6);
  EXPECT_NEAR(about_y, load.moment_z, 1e-6);
  EXPECT_NEAR(bent.front_force - bent.rear_force, 200.0, 1e-6);
}

TEST(LoadedShaft, TurnsWithItsLoad) {
  const BentSpindle s;
  const Arrangement set = two_against_one(bearing::Layout::back_to_back);
  const ArrangementCondition condition{.speed = 3000 * rpm};
  const LoadedShaft in_y =
      solve_loaded_shaft(s.beam, set, s.places, condition, {.radial = 700.0, .moment = 5.0});
  const LoadedShaft in_z =
      solve_loaded_shaft(s.beam, set, s.places, condition, {.radial_z = 700.0, .moment_z = 5.0});
  ASSERT_TRUE(in_y.report.converged() && in_z.report.converged());
  // A quarter of a turn brings 20 balls back onto themselves.
  EXPECT_LT((in_y.y - in_z.z).norm(), 1e-8 * in_y.y.norm());
}

TEST(LoadedShaft, AnOIsStifferAtTheNoseThanAnX) {
  const BentSpindle s;
  const auto nose = [&](bearing::Layout layout) {
    const LoadedShaft bent =
        solve_loaded_shaft(s.beam, two_against_one(layout), s.places, {}, {.radial = 1000.0});
    EXPECT_TRUE(bent.report.converged());
    return bent.y[0];
  };
  EXPECT_LT(1.2 * nose(bearing::Layout::back_to_back), nose(bearing::Layout::face_to_face));
}

TEST(LoadedShaft, ALoadBeyondAllBearingsEndsAsOneOrTheOther) {
  const BentSpindle s;
  const Arrangement set = two_against_one(bearing::Layout::back_to_back);
  for (const double force : {1e4, 1e5, 1e6}) {
    const LoadedShaft bent =
        solve_loaded_shaft(s.beam, set, s.places, {.speed = 8000 * rpm}, {.radial = force});
    EXPECT_NE(bent.report.status, bearing::SolveStatus::not_run);
    if (bent.report.converged()) {
      EXPECT_TRUE(bent.y.allFinite());
    } else {
      EXPECT_EQ(bent.y.size(), 0);
    }
  }
}

TEST(LoadedShaft, ASetOnASpringKeepsItsForceUnderRadialLoad) {
  const BentSpindle s;
  const auto b = bearing_of_15_degrees();
  const Arrangement set({.front = {{b}, {b}},
                         .rear = {{b}},
                         .mounting = bearing::Mounting::spring,
                         .preload = bearing::PreloadForce{400.0}});
  const LoadedShaft bent =
      solve_loaded_shaft(s.beam, set, s.places, {.speed = 5000 * rpm}, {.radial = 300.0});
  ASSERT_TRUE(bent.report.converged());
  EXPECT_NEAR(bent.rear_force, 400.0, 1e-6);
  const Arrangement tandem({.layout = bearing::Layout::tandem,
                            .front = {{b}, {b}, {b}},
                            .mounting = bearing::Mounting::spring,
                            .preload = bearing::PreloadForce{400.0}});
  const LoadedShaft row =
      solve_loaded_shaft(s.beam, tandem, s.places, {.speed = 5000 * rpm}, {.radial = 300.0});
  ASSERT_TRUE(row.report.converged());
  EXPECT_NEAR(row.front_force, 400.0, 1e-6);
}

}  // namespace
}  // namespace raceway::spindle
