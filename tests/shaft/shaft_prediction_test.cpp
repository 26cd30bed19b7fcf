#include "shaft/shaft_prediction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "effects/catalogue.h"
#include "model/heat_split.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {

using namespace shaft;

namespace {

using bearing::Mounting;
using bearing::PreloadForce;

bearing::ArrangementDesign free_set(const bearing::Bearing& bearing) {
  const auto one = std::make_shared<const bearing::Bearing>(bearing);
  return {.front = {{one}, {one}}, .rear = {{one}}, .preload = PreloadForce{600}};
}

Model measured_shaft() {
  Model model = synthetic_model();
  model.shaft = Shaft{bearing::Arrangement(free_set(model.bearing))};
  return model;
}

Model measured_shaft_with(const char* id, std::vector<double> values) {
  Model model = measured_shaft();
  model.effects.push_back(
      {.description = effects::find(id, effects::Form::shaft), .values = std::move(values)});
  return model;
}

ShaftPrediction at(const Model& model, const ShaftPoint& point) {
  auto p = predict_shaft(model, {&point, 1});
  EXPECT_TRUE(p[0].equilibrium.report.converged());
  return p[0];
}

constexpr ShaftPoint fast{.speed = 10000 * rpm};

// A set and a bearing alone are solved by different systems of equations.
TEST(ShaftPrediction, BallsThatNoRaceHoldsTurnInASetAsTheyDoAlone) {
  Model model = measured_shaft();
  model.law = friction::FrictionLaw::contact;
  model.law_values.clear();
  for (const friction::Parameter& p : friction::parameters(model.law))
    model.law_values.push_back(p.initial);
  const ShaftPoint point{.speed = 10000 * rpm, .external_load = -200, .temperature = kelvin(45)};
  const double held = at(model, point).displacement;
  model.balanced_balls = true;
  const ShaftPrediction p = at(model, point);
  EXPECT_GT(std::abs(p.displacement - held), 0.5 * um);  // it moves the shaft
  Model alone = model;
  alone.shaft.reset();
  for (std::size_t i = 0; i < 3; ++i) {
    const bearing::BearingInSet& in_set = p.equilibrium.bearings[i];
    const FrictionPrediction one = predict_friction(
        alone,
        {.speed = point.speed, .axial_load = in_set.axial_load, .temperature = point.temperature},
        true);
    ASSERT_TRUE(one.report.converged());
    const bearing::BallEquilibrium ball = one.equilibrium->balls[0];
    EXPECT_NEAR(in_set.displacement, one.equilibrium->displacement[0], 1e-11);
    EXPECT_NEAR(in_set.ball.outer_contact_angle, ball.outer_contact_angle, 1e-7);
    EXPECT_NEAR(in_set.ball.inner_friction, ball.inner_friction, 1e-6 * ball.inner_load);
    EXPECT_NEAR(p.friction[i].torque, one.torque, 1e-6 * one.torque);
    ASSERT_TRUE(in_set.rotation.has_value());
  }
}

TEST(ShaftPrediction, FrictionIsThatOfEveryBearingUnderTheLoadOfItsSet) {
  const Model model = measured_shaft_with("spin-friction", {0.06});
  const ShaftPrediction p = at(model, {.speed = 8000 * rpm, .external_load = -200});
  Model alone = model;
  alone.shaft.reset();
  double torque = 0.0, heat = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const bearing::OperatingPoint point{.speed = 8000 * rpm,
                                        .axial_load = p.equilibrium.bearings[i].axial_load};
    const FrictionPrediction one = predict_friction(alone, point, true);
    EXPECT_NEAR(p.friction[i].torque, one.torque, 1e-12 * one.torque);
    EXPECT_GT(one.effects[0], 0.0);
    torque += one.torque;
    heat += p.heat[i].inner + p.heat[i].outer;
  }
  EXPECT_NEAR(p.torque, torque, 1e-12 * torque);
  EXPECT_NEAR(p.power_loss, torque * 8000 * rpm, 1e-9);
  EXPECT_NEAR(heat, p.power_loss, 1e-9 * heat);
}

TEST(ShaftPrediction, DisplacementIsAgainstStandstillUnderTheSameLoad) {
  const Model model = measured_shaft();
  for (const double load : {0.0, 350.0, -350.0}) {
    EXPECT_NEAR(at(model, {.external_load = load}).displacement, 0.0, 1e-15);
    const auto p = at(model, {.speed = 9000 * rpm, .external_load = load});
    const auto still =
        solve_arrangement(model.shaft->arrangement, {.external_load = load}).position;
    EXPECT_NEAR(p.displacement, p.equilibrium.position - still, 1e-15);
    EXPECT_GT(p.displacement, 1 * um);
  }
}

TEST(ShaftPrediction, EveryPointIsTheSameAloneAndInASweep) {
  const Model model = measured_shaft();
  std::vector<ShaftPoint> points;
  for (int i = 0; i <= 12; ++i)
    points.push_back({.speed = i * 1000 * rpm, .temperature = kelvin(30 + i)});
  const auto sweep = predict_shaft(model, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto alone = at(model, points[i]);
    EXPECT_NEAR(sweep[i].displacement, alone.displacement, 1e-14);
    EXPECT_NEAR(sweep[i].torque, alone.torque, 1e-9 * alone.torque);
  }
}

TEST(ShaftPrediction, RingGrowthOfAnEffectLoadsTheSetsAndASpringTakesItUp) {
  const double plain = at(measured_shaft(), fast).equilibrium.front_force;
  Model grown = measured_shaft_with("centrifugal-ring-growth", {5.0});
  EXPECT_GT(at(grown, fast).equilibrium.front_force, 1.05 * plain);
  // The same growth as a shift of the grooves.
  bearing::ArrangementCondition condition{.speed = fast.speed};
  condition.shifts.assign(3, {.radial = 5.0 * um});
  EXPECT_NEAR(at(grown, fast).displacement,
              solve_arrangement(grown.shaft->arrangement, condition).position, 1e-14);
  // Friction is that of the balls in the set.
  const auto p = at(grown, fast);
  EXPECT_EQ(p.friction[0].equilibrium->balls[0].inner_contact_angle,
            p.equilibrium.bearings[0].ball.inner_contact_angle);
  auto design = free_set(grown.bearing);
  design.mounting = Mounting::spring;
  grown.shaft->arrangement = bearing::Arrangement(design);
  EXPECT_NEAR(at(grown, fast).equilibrium.rear_force, 600, 1e-6);
}

TEST(ShaftPrediction, OtherBallsReplaceThoseOfEveryBearing) {
  const Model ceramic = measured_shaft_with("ball-material", {1.0});
  Model entered = measured_shaft();
  entered.bearing =
      bearing::Bearing(entered.bearing.geometry(), bearing::silicon_nitride(), bearing::steel());
  entered.shaft = Shaft{bearing::Arrangement(free_set(entered.bearing))};
  const auto p = at(ceramic, fast), q = at(entered, fast);
  EXPECT_NEAR(p.displacement, q.displacement, 1e-14);
  EXPECT_NEAR(p.torque, q.torque, 1e-9 * q.torque);
  // Lighter balls push less.
  EXPECT_LT(p.displacement, 0.7 * at(measured_shaft(), fast).displacement);
}

TEST(ShaftPrediction, TemperaturesShiftTheShaftAtStandstillToo) {
  Model model = measured_shaft();
  auto design = free_set(model.bearing);
  design.distance = 150 * mm;
  const bearing::Arrangement arrangement(design);
  // The shaft alone is warmer; what is not given stays at the mounting temperature.
  model.shaft = Shaft{arrangement, 0.0, bearing::SetTemperatures{.shaft = kelvin(22)}};
  const auto p = at(model, {});
  EXPECT_LT(p.equilibrium.front_force, 500);
  EXPECT_GT(p.displacement, 1 * um);
  // Friction is that of the balls in the warm set.
  model.shaft->temperatures = bearing::SetTemperatures{.inner_ring = kelvin(26)};
  const auto q = at(model, fast);
  EXPECT_GT(q.equilibrium.front_force, 1.1 * at(measured_shaft(), fast).equilibrium.front_force);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(q.friction[i].equilibrium->balls[0].inner_contact_angle,
              q.equilibrium.bearings[i].ball.inner_contact_angle);
  // The base law is that of the entered bearing under the load that it carries.
  Model alone = model;
  alone.shaft.reset();
  const FrictionPrediction one = predict_friction(
      alone, {.speed = fast.speed, .axial_load = q.equilibrium.bearings[2].axial_load});
  EXPECT_NEAR(q.friction[2].load, one.load, 1e-12 * one.load);
}

TEST(ShaftPrediction, HeatOfTheRingsIsThePowerLossWhateverTheBallsAreOf) {
  Model model = measured_shaft_with("ball-material", {1.0});
  for (const char* id : {"spin-friction", "centrifugal-ring-growth"})
    model.effects.push_back({.description = effects::find(id, effects::Form::shaft),
                             .values = {id == std::string("spin-friction") ? 0.06 : 5.0}});
  const auto p = at(model, fast);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(p.heat[i].inner + p.heat[i].outer, p.friction[i].power_loss,
                1e-12 * p.friction[i].power_loss);
}

TEST(ShaftPrediction, ATiltGrowsOutOfNothing) {
  const auto torque = [](double tilt) {
    Model model = measured_shaft_with("spin-friction", {0.06});
    model.effects.push_back(
        {.description = effects::find("misalignment", effects::Form::shaft), .values = {tilt}});
    return at(model, fast).torque;
  };
  EXPECT_NEAR(torque(1e-4), torque(0.0), 1e-7 * torque(0.0));
  EXPECT_GT(torque(1.0), torque(0.0));
}

TEST(ShaftPrediction, ABearingThatHasLostContactHasBallsOnItsOuterRingAlone) {
  const Model model = measured_shaft_with("spin-friction", {0.06});
  const auto p = at(model, {.speed = 0.0, .external_load = 2000});
  ASSERT_TRUE(p.equilibrium.bearings[0].lost());
  EXPECT_EQ(p.friction[0].effects[0], 0.0) << "nothing presses the balls that spin";
  EXPECT_EQ(p.friction[0].torque, p.friction[0].viscous);
  EXPECT_TRUE(std::isfinite(p.torque));
}

TEST(ShaftPrediction, PointsWithoutBalanceHaveNoNumbers) {
  Model model = measured_shaft();
  auto design = free_set(model.bearing);
  design.mounting = Mounting::spring;
  model.shaft->arrangement = bearing::Arrangement(design);
  const ShaftPoint pulled{.speed = 1000 * rpm, .external_load = 900};
  const auto p = predict_shaft(model, {&pulled, 1});
  EXPECT_EQ(p[0].equilibrium.report.status, bearing::SolveStatus::no_equilibrium);
  EXPECT_TRUE(std::isnan(p[0].displacement));
  EXPECT_TRUE(std::isnan(p[0].torque));
  EXPECT_THROW((void)predict_shaft(synthetic_model(), {&pulled, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::fit
