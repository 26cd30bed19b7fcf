// Sets of bearings on a shaft: numbers of other programs and makers, and what must hold for any.

#include "bearing/arrangement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/rigid_preload.h"
#include "tests/bearing/expect.h"
#include "tests/reference_table.h"

namespace raceway::bearing {
namespace {

using tests::expect_relative;
using tests::reference_table;

using BearingPointer = std::shared_ptr<const Bearing>;

BearingPointer made(const BearingGeometry& geometry, const Material& balls = steel()) {
  return std::make_shared<const Bearing>(geometry, balls, steel());
}

BearingGeometry geometry(double contact_angle = 25 * degree) {
  return {.ball_count = 20,
          .ball_diameter = 11.9 * mm,
          .pitch_diameter = 90 * mm,
          .contact_angle = contact_angle,
          .inner_conformity = 0.52,
          .outer_conformity = 0.52};
}

std::vector<MountedBearing> set_of(std::size_t count, const BearingPointer& bearing) {
  return {count, {bearing}};
}

ArrangementDesign spindle(std::size_t front = 2, std::size_t rear = 1) {
  static const BearingPointer bearing = made(geometry());
  return {
      .front = set_of(front, bearing), .rear = set_of(rear, bearing), .preload = PreloadForce{600}};
}

ArrangementEquilibrium solved(const ArrangementDesign& design,
                              const ArrangementCondition& condition) {
  auto e = solve_arrangement(Arrangement(design), condition);
  EXPECT_TRUE(e.report.converged()) << name(e.report.status);
  return e;
}

ArrangementEquilibrium at_speed(const ArrangementDesign& design, double speed,
                                double external_load = 0.0) {
  return solved(design, {.speed = speed, .external_load = external_load});
}

TEST(Arrangement, MovesTheShaftAsOtherProgramsComputed) {
  for (const auto& row : reference_table("shaft_displacement.csv")) {
    SCOPED_TRACE(row.place());
    const auto bearing = made({.ball_count = static_cast<int>(row["ball_count"]),
                               .ball_diameter = row["ball_diameter_mm"] * mm,
                               .pitch_diameter = row["pitch_diameter_mm"] * mm,
                               .contact_angle = row["contact_angle_deg"] * degree,
                               .inner_conformity = row["conformity"],
                               .outer_conformity = row["conformity"]});
    const auto e = at_speed({.front = set_of(static_cast<std::size_t>(row["front"]), bearing),
                             .rear = set_of(static_cast<std::size_t>(row["rear"]), bearing),
                             .preload = PreloadForce{row["preload_N"]}},
                            row["speed_rpm"] * rpm);
    EXPECT_NEAR(e.position / um, row["axial_displacement_um"], row["tolerance_um"]);
  }
}

// The solver of sets, which other programs' numbers hold, has the same pair with all its balls.
TEST(Arrangement, ThrustOnTheRelievedBearingOfARigidPair) {
  ArrangementDesign pair = spindle(1, 1);
  for (const double preload : {150.0, 600.0})
    for (const double speed : {0.0, 6000 * rpm, 15000 * rpm})
      for (const double load : {0.0, 200.0}) {
        pair.preload = PreloadForce{preload};
        const ArrangementEquilibrium e = at_speed(pair, speed, load);
        const double expected = std::min(e.front_force, e.rear_force);
        EXPECT_NEAR(relieved_thrust(*pair.front[0].bearing, preload, load, speed), expected,
                    1e-3 * std::max(expected, preload))
            << preload << " N, " << load << " N, " << speed / rpm << " rpm";
      }
  EXPECT_EQ(relieved_thrust(*pair.front[0].bearing, 100.0, 600.0, 0.0), 0.0);
}

// The other solver finds the displacement for a load; here the loads follow from displacements.
TEST(Arrangement, EveryBearingIsInBalanceUnderTheLoadItGets) {
  ArrangementDesign design = spindle(2, 1);
  design.rear = set_of(1, made(geometry(15 * degree), silicon_nitride()));
  const Arrangement arrangement(design);
  for (const double speed : {0.0, 4000 * rpm, 16000 * rpm}) {
    const auto e = solve_arrangement(arrangement, {.speed = speed, .external_load = 150});
    ASSERT_TRUE(e.report.converged());
    EXPECT_NEAR(e.front_force - e.rear_force + 150, 0.0, 1e-7);
    for (std::size_t i = 0; i < 3; ++i) {
      const BearingInSet& b = e.bearings[i];
      const auto alone = solve_bearing_equilibrium(*arrangement.bearings()[i].bearing,
                                                   {.speed = speed, .axial_load = b.axial_load});
      ASSERT_TRUE(alone.report.converged());
      EXPECT_NEAR(b.displacement, alone.displacement[0], 1e-15);
      expect_relative(b.axial_stiffness, alone.stiffness(0, 0), 1e-7);
      expect_relative(b.ball.inner_load, alone.balls[0].inner_load, 1e-8);
      expect_relative(b.ball.inner_contact_angle, alone.balls[0].inner_contact_angle, 1e-8);
      expect_relative(b.ball.outer_contact_angle, alone.balls[0].outer_contact_angle, 1e-8);
      expect_relative(b.ball.gyroscopic_moment, alone.balls[0].gyroscopic_moment, 1e-7);
      const auto full = e.bearing(i, arrangement);
      EXPECT_EQ(full.balls.size(), 20u);
      EXPECT_EQ(full.displacement[0], b.displacement);
      EXPECT_DOUBLE_EQ(full.balls[5].azimuth, pi / 2.0);
    }
  }
}

TEST(Arrangement, EqualSetsDoNotMove) {
  for (const std::size_t count : {1u, 2u, 3u})
    for (const Layout layout : {Layout::back_to_back, Layout::face_to_face}) {
      ArrangementDesign design = spindle(count, count);
      design.layout = layout;
      EXPECT_NEAR(at_speed(design, 12000 * rpm).position, 0.0, 1e-15);
    }
}

TEST(Arrangement, MirrorsWithItsSetsAndWithItsLayout) {
  ArrangementDesign design = spindle(2, 1);
  const auto o = at_speed(design, 10000 * rpm, 80);
  ArrangementDesign swapped = spindle(1, 2);
  const auto mirrored = at_speed(swapped, 10000 * rpm, -80);
  EXPECT_NEAR(mirrored.position, -o.position, 1e-15);
  expect_relative(mirrored.front_force, o.rear_force, 1e-9);
  design.layout = Layout::face_to_face;
  const auto x = at_speed(design, 10000 * rpm, -80);
  EXPECT_NEAR(x.position, -o.position, 1e-15);
  expect_relative(x.front_force, o.front_force, 1e-9);
  expect_relative(x.axial_stiffness, o.axial_stiffness, 1e-9);
}

TEST(Arrangement, StiffnessIsTheDifferenceQuotientOfTheExternalLoad) {
  ArrangementDesign soft = spindle();
  soft.shaft_stiffness = 400 * N_per_um;
  soft.housing_stiffness = 900 * N_per_um;
  ArrangementDesign spring = spindle();
  spring.mounting = Mounting::spring;
  spring.spring_rate = 30 * N_per_um;
  for (const ArrangementDesign& design : {spindle(), soft, spring})
    for (const double speed : {0.0, 9000 * rpm}) {
      const double h = 0.1;
      const double slope =
          2.0 * h / (at_speed(design, speed, h).position - at_speed(design, speed, -h).position);
      expect_relative(at_speed(design, speed).axial_stiffness, slope, 1e-6);
    }
}

TEST(Arrangement, SpringKeepsTheRearForce) {
  ArrangementDesign design = spindle();
  design.mounting = Mounting::spring;
  for (const double speed : {0.0, 3000 * rpm, 20000 * rpm})
    expect_relative(at_speed(design, speed).rear_force, 600, 1e-10);
  // A rate lets it follow the spring's compression: both ends of it are reported.
  design.spring_rate = 5 * N_per_um;
  const Arrangement arrangement(design);
  const auto e = solved(design, {.speed = 20000 * rpm});
  const double compression =
      e.position - (e.rear_displacement - arrangement.displacement(Side::rear));
  EXPECT_GT(compression, 1 * um);
  expect_relative(e.rear_force, 600 + 5 * N_per_um * compression, 1e-9);
}

TEST(Arrangement, StiffSpringIsARigidMountingWithSeriesStiffness) {
  ArrangementDesign spring = spindle();
  spring.mounting = Mounting::spring;
  spring.spring_rate = 250 * N_per_um;
  ArrangementDesign rigid = spindle();
  rigid.shaft_stiffness = 250 * N_per_um;
  const auto a = at_speed(spring, 10000 * rpm), b = at_speed(rigid, 10000 * rpm);
  EXPECT_NEAR(a.position, b.position, 1e-14);
  expect_relative(a.rear_force, b.rear_force, 1e-9);
  // Compliance takes the growth of the forces away.
  EXPECT_LT(b.rear_force, at_speed(spindle(), 10000 * rpm).rear_force);
  rigid.shaft_stiffness = 1e9 * N_per_um;
  EXPECT_NEAR(at_speed(rigid, 10000 * rpm).position, at_speed(spindle(), 10000 * rpm).position,
              1e-12);
}

TEST(Arrangement, TandemIsHeldByItsSpring) {
  ArrangementDesign design = spindle(3, 1);
  design.rear.clear();
  design.layout = Layout::tandem;
  design.mounting = Mounting::spring;
  const auto e = at_speed(design, 10000 * rpm, -200);
  expect_relative(e.front_force, 800, 1e-10);
  expect_relative(e.rear_force, 600, 1e-10);
  expect_relative(e.bearings[1].axial_load, 800.0 / 3.0, 1e-10);
  // What pulls harder than the spring pulls the shaft out.
  EXPECT_EQ(solve_arrangement(Arrangement(design), {.external_load = 700}).report.status,
            SolveStatus::no_equilibrium);
}

TEST(Arrangement, PreloadOffsetAndPreloadForceAreTwoWordsForOneState) {
  for (const double series : {150 * N_per_um, std::numeric_limits<double>::infinity()}) {
    ArrangementDesign design = spindle();
    design.shaft_stiffness = series;
    design.front[1].offset = 0.5 * um;
    const Arrangement by_force(design);
    // From where the front set just touches, half a micrometre early.
    design.preload = PreloadOffset{by_force.displacement(Side::front) + 0.5 * um +
                                   by_force.displacement(Side::rear) + 600 / series};
    const Arrangement by_offset(design);
    expect_relative(by_offset.preload(), 600, 1e-10);
    EXPECT_NEAR(by_offset.displacement(Side::rear), by_force.displacement(Side::rear), 1e-15);
  }
}

TEST(Arrangement, MatchedBearingsGiveTheSetsOfTheCatalogueTheirPreload) {
  const auto bearing = made(geometry());
  // So light that the contact angle stays.
  const double pair = 5;
  for (const auto& row : reference_table("snfa_set_preload.csv")) {
    SCOPED_TRACE(row.place());
    ArrangementDesign design =
        spindle(static_cast<std::size_t>(row["front"]), static_cast<std::size_t>(row["rear"]));
    design.preload = matched_preload(*bearing, pair, *bearing, pair);
    expect_relative(Arrangement(design).preload() / pair, row["factor"], row["relative_tolerance"]);
  }
}

TEST(Arrangement, ComesFreeAtTheLoadsOfTheCatalogue) {
  for (const auto& row : reference_table("snfa_set_lift_off.csv")) {
    SCOPED_TRACE(row.place());
    const ArrangementDesign design{
        .front = set_of(static_cast<std::size_t>(row["front"]),
                        made(geometry(row["front_contact_angle_deg"] * degree))),
        .rear = set_of(static_cast<std::size_t>(row["rear"]),
                       made(geometry(row["rear_contact_angle_deg"] * degree))),
        .preload = PreloadForce{1}};
    const LiftOff free = lift_off(Arrangement(design));
    expect_relative(-free.rear, row["load_on_front_over_preload"], row["relative_tolerance"]);
    expect_relative(free.front, row["load_on_rear_over_preload"], row["relative_tolerance"]);
  }
}

// As AxialRigidity.LiftOffOfAPairExceedsThatOfAConstantContactAngle: a bearing of similar size.
TEST(Arrangement, PairComesFreeAtTheLoadPrintedByAMaker) {
  const auto bearing = made({.ball_count = 18,
                             .ball_diameter = 12.7 * mm,
                             .pitch_diameter = 90 * mm,
                             .contact_angle = 15 * degree,
                             .inner_conformity = 0.53,
                             .outer_conformity = 0.53});
  for (const auto& row : reference_table("pair_lift_off.csv")) {
    SCOPED_TRACE(row.place());
    const LiftOff free = lift_off(Arrangement(
        {.front = set_of(1, bearing), .rear = set_of(1, bearing), .preload = PreloadForce{270}}));
    expect_relative(free.front / 270, row["lift_off_force_N"] / row["preload_N"],
                    row["relative_tolerance"]);
  }
}

TEST(Arrangement, PairHasTheRigidityPrintedByMakers) {
  for (const auto& row : reference_table("pair_axial_rigidity.csv")) {
    SCOPED_TRACE(row.place());
    const auto bearing = made({.ball_count = static_cast<int>(row["ball_count"]),
                               .ball_diameter = row["ball_diameter_m"],
                               .pitch_diameter = row["pitch_diameter_m"],
                               .contact_angle = row["contact_angle_deg"] * degree,
                               .inner_conformity = row["conformity"],
                               .outer_conformity = row["conformity"]});
    const double preload = row["preload_N"];
    const Arrangement pair({.front = set_of(1, bearing),
                            .rear = set_of(1, bearing),
                            .preload = PreloadForce{preload}});
    const double rigidity = row.text("definition") == "secant"
                                ? 2.83 * preload / pair.displacement(Side::front)
                                : solve_arrangement(pair, {}).axial_stiffness;
    expect_relative(rigidity, row["axial_rigidity_N_m"], row["relative_tolerance"]);
  }
}

// A soft spring would have to be pressed by a millimetre and more: "comes free at -543677 N".
TEST(Arrangement, ASetOnASoftSpringComesFreeAtNoLoadThatTheOtherOneEndures) {
  const auto pair = [](double rate) {
    const auto bearing =
        std::make_shared<const Bearing>(BearingGeometry{.ball_count = 20,
                                                        .ball_diameter = 11.906 * mm,
                                                        .pitch_diameter = 90 * mm,
                                                        .contact_angle = 25 * degree,
                                                        .inner_conformity = 0.52,
                                                        .outer_conformity = 0.52},
                                        steel(), steel());
    return lift_off(Arrangement({.front = {{bearing}},
                                 .rear = {{bearing}},
                                 .mounting = Mounting::spring,
                                 .preload = PreloadForce{600},
                                 .spring_rate = rate}));
  };
  EXPECT_TRUE(std::isnan(pair(0.5 * N_per_um).rear));
  EXPECT_GT(pair(0.5 * N_per_um).front, 600);
  // A stiff one is pulled open long before.
  EXPECT_LT(pair(100 * N_per_um).rear, -600);
  EXPECT_GT(pair(100 * N_per_um).rear, -20000);
}

TEST(Arrangement, ExternalLoadAtLiftOffFreesASide) {
  ArrangementDesign design = spindle(2, 1);
  design.housing_stiffness = 700 * N_per_um;
  design.front[0].offset = 0.3 * um;
  for (const Layout layout : {Layout::back_to_back, Layout::face_to_face}) {
    design.layout = layout;
    const LiftOff free = lift_off(Arrangement(design));
    EXPECT_NEAR(at_speed(design, 0, 1.0001 * free.front).front_force, 0.0, 1e-9);
    EXPECT_GT(at_speed(design, 0, 0.999 * free.front).front_force, 1e-4);
    EXPECT_NEAR(at_speed(design, 0, 1.0001 * free.rear).rear_force, 0.0, 1e-9);
    EXPECT_GT(at_speed(design, 0, 0.999 * free.rear).rear_force, 1e-4);
  }
}

SetTemperatures uniform(double celsius) {
  const double t = kelvin(celsius);
  return {.inner_ring = t, .outer_ring = t, .shaft = t, .housing = t};
}

ArrangementEquilibrium heated(ArrangementDesign design, const SetTemperatures& t,
                              double speed = 0.0) {
  design.distance = 200 * mm;
  const Arrangement arrangement(design);
  ArrangementCondition condition{.speed = speed};
  add_expansion(arrangement, t, condition);
  auto e = solve_arrangement(arrangement, condition);
  EXPECT_TRUE(e.report.converged()) << name(e.report.status);
  return e;
}

TEST(Arrangement, OneTemperatureOfEverythingChangesNothing) {
  for (const double speed : {0.0, 10000 * rpm}) {
    const auto cold = at_speed(spindle(), speed);
    const auto hot = heated(spindle(), uniform(70), speed);
    // Only the scale: 50 K * 11.5e-6 is 0.06 %.
    EXPECT_NEAR(hot.position, cold.position, 2e-3 * um);
    expect_relative(hot.front_force, cold.front_force, 3e-3);
  }
}

TEST(Arrangement, WarmShaftRelievesOAndTightensX) {
  SetTemperatures t = uniform(20);
  t.shaft = kelvin(21);
  ArrangementDesign design = spindle(1, 1);
  EXPECT_LT(heated(design, t).front_force, 560);
  // e = 2.3 um over a pair: each side gives half, the shaft moves by it.
  const double e = 200 * mm * 11.5 * per_million_K;
  expect_relative(heated(design, t).position, 0.5 * e, 0.02);
  design.layout = Layout::face_to_face;
  EXPECT_GT(heated(design, t).front_force, 640);
  // Twice the distance is twice the elongation.
  ArrangementCondition condition;
  design.distance = 400 * mm;
  add_expansion(Arrangement(design), t, condition);
  expect_relative(condition.elongation, 2.0 * e, 1e-12);
}

TEST(Arrangement, WarmInnerRingsRaiseThePreload) {
  SetTemperatures t = uniform(20);
  t.inner_ring = kelvin(25);
  t.balls = kelvin(20);
  const auto bearing = made(geometry());
  // λ ΔT R_i, and the grooves' own growth.
  const RingShift shift = thermal_shift(*bearing, t, kelvin(20));
  expect_relative(shift.radial, 11.5e-6 * 5 * geometry().inner_groove_centre_radius(), 1e-12);
  expect_relative(shift.inner_length, 11.5e-6 * 5 * 0.52 * 11.9 * mm, 1e-12);
  EXPECT_EQ(shift.outer_length, 0.0);
  EXPECT_GT(heated(spindle(), t).front_force, 650);
  // Ceramic balls in rings that are all warm are too small for them.
  ArrangementDesign hybrid = spindle();
  hybrid.front = set_of(2, made(geometry(), silicon_nitride()));
  hybrid.rear = set_of(1, hybrid.front[0].bearing);
  EXPECT_LT(heated(hybrid, uniform(30)).front_force, 500);
}

TEST(Arrangement, UnsetTemperaturesAreNamed) {
  ArrangementCondition condition;
  SetTemperatures t = uniform(30);
  t.shaft = unset;
  try {
    add_expansion(Arrangement(spindle()), t, condition);
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("shaft"));
  }
}

TEST(Arrangement, OffsetWithinATandemSharesTheLoadUnequally) {
  ArrangementDesign design = spindle(2, 1);
  design.front[0].offset = 1 * um;
  const auto e = at_speed(design, 0);
  EXPECT_NEAR(e.bearings[0].displacement - e.bearings[1].displacement, 1 * um, 1e-15);
  EXPECT_GT(e.bearings[0].axial_load, 1.2 * e.bearings[1].axial_load);
  expect_relative(e.bearings[0].axial_load + e.bearings[1].axial_load, 600, 1e-10);
}

TEST(Arrangement, LostBearingCarriesNothing) {
  ArrangementDesign design = spindle(2, 1);
  design.front[0].offset = -20 * um;
  const auto e = at_speed(design, 0);
  EXPECT_TRUE(e.bearings[0].lost());
  EXPECT_EQ(e.bearings[0].axial_load, 0.0);
  EXPECT_TRUE(std::isnan(e.bearings[0].ball.inner_contact_angle));
  expect_relative(e.bearings[1].axial_load, 600, 1e-10);
}

TEST(Arrangement, ShaftThatNothingHoldsIsSingular) {
  const Arrangement arrangement(spindle());
  // 60 um longer than the preload of 12 um can follow.
  EXPECT_EQ(solve_arrangement(arrangement, {.elongation = 60 * um}).report.status,
            SolveStatus::singular);
  // A load presses it against one side again.
  const auto e = solve_arrangement(arrangement, {.external_load = -100, .elongation = 60 * um});
  ASSERT_TRUE(e.report.converged());
  expect_relative(e.front_force, 100, 1e-9);
  EXPECT_TRUE(e.bearings[2].lost());
}

TEST(Arrangement, MinimumLoadIsWhatAMakerAsksOfSprings) {
  int series_s = 0;
  for (const auto& row : tests::data_table("bearings/gmn_spindle.csv")) {
    const std::string series = row.text("designation").substr(0, 2);
    const Bearing bearing({.ball_count = static_cast<int>(row["ball_count"]),
                           .ball_diameter = row["ball_diameter_mm"] * mm,
                           .pitch_diameter = row["pitch_diameter_mm"] * mm,
                           .contact_angle = row["contact_angle_deg"] * degree,
                           .inner_conformity = 0.52,
                           .outer_conformity = 0.52},
                          steel(), steel());
    const double printed = row["min_spring_preload_at_max_speed_N"];
    const double speed = row["speed_limit_oil_rpm"] * rpm;
    const auto e = solve_bearing_equilibrium(bearing, {.speed = speed, .axial_load = printed});
    ASSERT_TRUE(e.report.converged());
    const double ratio = printed / minimum_load(bearing, e.balls[0].centrifugal_force);
    SCOPED_TRACE(row.text("designation"));
    // The series with smaller balls go lower, to about half of it.
    EXPECT_GT(ratio, series == "S " ? 0.85 : 0.45);
    EXPECT_LT(ratio, 1.35);
    series_s += series == "S ";
  }
  EXPECT_GT(series_s, 40);
}

TEST(Arrangement, SweepAndColdStartAgree) {
  const Arrangement arrangement(spindle(3, 2));
  std::vector<ArrangementCondition> conditions(41);
  std::vector<ArrangementEquilibrium> sweep(41);
  for (std::size_t i = 0; i < 41; ++i) {
    conditions[i].speed = 500 * static_cast<double>(i) * rpm;
    conditions[i].external_load = i % 2 ? 300 : -300;
  }
  solve_arrangement(arrangement, conditions, sweep);
  for (std::size_t i = 0; i < 41; ++i) {
    const auto cold = solve_arrangement(arrangement, conditions[i]);
    ASSERT_TRUE(sweep[i].report.converged() && cold.report.converged());
    EXPECT_NEAR(sweep[i].position, cold.position, 1e-15);
    EXPECT_LE(sweep[i].report.recovered_load_error, 1e-10);
  }
  EXPECT_THROW(solve_arrangement(arrangement, conditions, std::span(sweep).first(3)),
               std::invalid_argument);
}

TEST(Arrangement, WrongDesignsAreNamed) {
  const auto message = [](const ArrangementDesign& design) -> std::string {
    try {
      const Arrangement a(design);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "accepted";
  };
  using testing::HasSubstr;
  ArrangementDesign d = spindle();
  d.front.clear();
  EXPECT_THAT(message(d), HasSubstr("front = 0: must be from 1 to 20"));
  d = spindle();
  d.rear.clear();
  EXPECT_THAT(message(d), HasSubstr("rear = 0"));
  d = spindle();
  d.layout = Layout::tandem;
  d.mounting = Mounting::spring;
  EXPECT_THAT(message(d), HasSubstr("a tandem arrangement has no second set"));
  d.rear.clear();
  d.mounting = Mounting::rigid;
  EXPECT_THAT(message(d), HasSubstr("a tandem arrangement needs a spring"));
  d = spindle();
  d.preload = PreloadForce{-5};
  EXPECT_THAT(message(d), HasSubstr("preload_force = -5 N: must be from 0"));
  d = spindle();
  d.preload = PreloadOffset{10 * um};
  d.mounting = Mounting::spring;
  EXPECT_THAT(message(d), HasSubstr("not possible with mounting = spring"));
  d = spindle();
  d.front[1].bearing = made(geometry(0.0));
  EXPECT_THAT(message(d), HasSubstr("front bearing 2: contact_angle = 0 deg: must be from 5"));
  EXPECT_THROW((void)solve_arrangement(Arrangement(spindle()), {.shifts = {RingShift{}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace raceway::bearing
