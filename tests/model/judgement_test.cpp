#include "model/judgement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/support/synthetic.h"

namespace raceway::model {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const bearing::Bearing& ball_bearing() {
  static const bearing::Bearing one = *fit::synthetic_model().bearing.ball_bearing();
  return one;
}

/// The finding of a limit; empty where there is none.
Finding of(const Limit& limit, const Findings& findings) {
  for (const Finding& f : findings)
    if (f.limit == limit.id) return f;
  return {};
}

Findings judged(const Model& model, const bearing::OperatingPoint& point,
                const JudgedBearing& state) {
  Judge judge(model);
  judge.look(ball_bearing(), "", point, state);
  return judge.findings();
}

TEST(Judgement, PressureOfARunningBearingIsJudgedBelowThatOfAStandingOne) {
  const Model model = fit::synthetic_model();
  const JudgedBearing pressed{.axial_load = 100.0, .radial_load = 0.0, .inner_pressure = 2.3e9};
  EXPECT_THAT(judged(model, {.speed = 0.0}, pressed), IsEmpty());
  const Finding running = of(limits::running_pressure, judged(model, {.speed = 100.0}, pressed));
  EXPECT_TRUE(running.is_warning);
  EXPECT_DOUBLE_EQ(running.value, 2.3);
  EXPECT_DOUBLE_EQ(running.allowed, 2.0);
  EXPECT_THAT(running.text,
              HasSubstr("the contact pressure of the running bearing is 2.3 GPa, above 2 GPa"));
  const JudgedBearing dented{.axial_load = 100.0, .radial_load = 0.0, .outer_pressure = 4.3e9};
  const Finding standing = of(limits::static_pressure, judged(model, {.speed = 0.0}, dented));
  EXPECT_FALSE(standing.is_warning);
  EXPECT_DOUBLE_EQ(standing.value, 4.3);
}

TEST(Judgement, RingsAreJudgedByTheHotterOne) {
  const Model model = fit::synthetic_model();
  const auto rings = [&](double inner, double outer) {
    return of(limits::ring_temperature, judged(model, {.speed = 10.0},
                                               {.axial_load = 1.0,
                                                .radial_load = 0.0,
                                                .inner_ring_temperature = kelvin(inner),
                                                .outer_ring_temperature = kelvin(outer)}));
  };
  EXPECT_TRUE(rings(80.0, 79.0).limit.empty());
  EXPECT_NEAR(rings(60.0, 81.5).value, 81.5, 1e-9);
  EXPECT_NEAR(rings(124.7, 81.5).value, 124.7, 1e-9);
  EXPECT_NEAR(rings(124.7, 81.5).allowed, 80.0, 1e-9);
}

// An external load of 2000 N presses the front set to 2600 N and leaves 600 N behind: the sets are
// not preloaded by more than that.
TEST(Judgement, PreloadIsWhatBothSetsCarry) {
  const Model model = fit::synthetic_model();
  const auto factor = [&](double front, double rear) {
    Judge judge(model);
    judge.look_at_preload({.speed = 100.0}, front, rear, 300.0);
    return of(limits::preload_factor, judge.findings());
  };
  EXPECT_TRUE(factor(2600.0, 600.0).limit.empty());
  EXPECT_TRUE(factor(900.0, 900.0).limit.empty());
  EXPECT_NEAR(factor(2400.0, 2500.0).value, 8.0, 1e-12);
  EXPECT_THAT(factor(2400.0, 2500.0).text,
              HasSubstr("2400 N, 8 times the mounted preload of 300 N"));
}

TEST(Judgement, ABearingWithTooLittleLoadIsReported) {
  const Model model = fit::synthetic_model();
  const auto little = [&](double load) {
    return of(limits::minimum_load,
              judged(model, {.speed = 100.0},
                     {.axial_load = load, .radial_load = 0.0, .minimum_load = 50.0}));
  };
  EXPECT_TRUE(little(50.5).limit.empty());
  EXPECT_FALSE(little(30.0).is_warning);
  EXPECT_DOUBLE_EQ(little(30.0).value, 30.0);
  EXPECT_DOUBLE_EQ(little(30.0).allowed, 50.0);
  EXPECT_THAT(little(30.0).text,
              HasSubstr("the axial load of 30 N is below the minimum load of 50 N"));
}

TEST(Judgement, TheWorstPointIsFarthestFromItsLimit) {
  const Model model = fit::synthetic_model();
  Judge fast(model), slow(model);
  fast.look(ball_bearing(), "", {.speed = 200.0}, {.axial_load = 60.0, .minimum_load = 200.0});
  slow.look(ball_bearing(), "", {.speed = 100.0}, {.axial_load = 30.0, .minimum_load = 50.0});
  slow.add(fast);
  EXPECT_DOUBLE_EQ(of(limits::minimum_load, slow.findings()).value, 60.0);
}

TEST(Judgement, SpeedsGoByTheCatalogueTheSupplyAndTheBalls) {
  Model model = fit::synthetic_model();
  model.printed_speed = {.oil = 19000 * rpm, .grease = 14000 * rpm};
  const auto passed = [&](double speed_rpm, bool ceramic) {
    Judge judge(model);
    judge.look_at_speed(90 * mm, ceramic, "", {.speed = speed_rpm * rpm});
    return of(limits::catalogue_speed, judge.findings());
  };
  EXPECT_TRUE(passed(18999.0, false).limit.empty());
  EXPECT_NEAR(passed(19500.0, false).allowed, 19000.0, 1e-6);
  EXPECT_TRUE(passed(23000.0, true).limit.empty());  // 1.25 times 19 000 rpm
  EXPECT_FALSE(passed(24000.0, true).limit.empty());
  model.supply = friction::Supply::grease;
  EXPECT_NEAR(passed(15000.0, false).allowed, 14000.0, 1e-6);
  model.printed_speed = {};
  // 18 000 rpm on 90 mm is the speed factor 1.62e6 of the catalogue's fastest with grease.
  const auto factor = [&](double speed_rpm) {
    Judge judge(model);
    judge.look_at_speed(90 * mm, false, "", {.speed = speed_rpm * rpm});
    return of(limits::speed_factor, judge.findings());
  };
  EXPECT_TRUE(factor(17990.0).limit.empty());
  EXPECT_NEAR(factor(18100.0).value, 1.629e6, 1.0);
}

// By ASTM D341 with the two given viscosities, reckoned apart: an oil of 32 and 5.4 mm²/s has 1e5
// mm²/s at -45.48 C and 1e7 at -65.03 C.
TEST(Judgement, AnOilIsStiffBelowAndThenSolid) {
  const friction::Lubricant oil(32 * mm2_per_s, 5.4 * mm2_per_s);
  EXPECT_NEAR(celsius(possible_temperatures(oil).lower), -65.03, 0.1);
  Model model = fit::synthetic_model();
  model.lubricant = oil;
  const auto stiff = [&](double temperature_C) {
    Judge judge(model);
    judge.look_at_speed(50 * mm, false, "", {.speed = 10.0, .temperature = kelvin(temperature_C)});
    return of(limits::oil_stiff, judge.findings());
  };
  EXPECT_TRUE(stiff(-45.0).limit.empty());
  EXPECT_GT(stiff(-46.0).value, 1e5);
}

// ρ v² = 2 GPa with 7800 kg/m³ is 506 m/s at the raceway.
TEST(Judgement, ARingBurstsAtItsHoopStress) {
  const Model model = fit::synthetic_model();
  const bearing::BearingGeometry& g = ball_bearing().geometry();
  const double raceway = g.pitch_diameter - g.ball_diameter * std::cos(g.contact_angle);
  const double density = ball_bearing().rings().density;
  EXPECT_NEAR(possible_speeds(model).upper * 0.5 * raceway, std::sqrt(2e9 / density), 1e-9);
}

TEST(Judgement, PartsOfAnAnswerAreOneJudgement) {
  const Model model = fit::synthetic_model();
  const auto at = [&](const std::vector<double>& temperatures_C) {
    Judge judge(model);
    for (const double t : temperatures_C)
      judge.look_at_speed(50 * mm, false, "", {.speed = 10.0, .temperature = kelvin(t)});
    return judge;
  };
  Judge all(model);
  for (const Judge& part : {at({250.0, 20.0}), at({20.0}), at({300.0, 270.0})}) all.add(part);
  const Finding together = of(limits::oil_hot, all.findings()),
                one = of(limits::oil_hot, at({250.0, 20.0, 20.0, 300.0, 270.0}).findings());
  EXPECT_EQ(together.points, 3U);
  EXPECT_NEAR(together.value, 300.0, 1e-9);
  EXPECT_EQ(together.text, one.text);
}

}  // namespace
}  // namespace raceway::model
