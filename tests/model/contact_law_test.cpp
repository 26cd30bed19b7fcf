#include "friction/contact/contact_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "effects/catalogue.h"
#include "model/needs.h"
#include "model/parameters.h"
#include "model/prediction.h"
#include "model/row_predictor.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

Model contact_model_with(std::string_view id, std::vector<double> values) {
  Model model = contact_model();
  model.effects.push_back({.description = effects::find(id), .values = std::move(values)});
  return model;
}

const bearing::OperatingPoint fast{
    .speed = 10000.0 * rpm, .axial_load = 500.0, .temperature = kelvin(40.0)};

double torque(const Model& model) { return predict_friction(model, fast, {}).torque; }

TEST(ContactLawInAModel, ConditionsReachTheTorqueThroughTheBalls) {
  const double plain = torque(contact_model());
  EXPECT_GT(torque(contact_model_with("load-offset", {100.0})), 1.01 * plain);
  EXPECT_GT(torque(contact_model_with("thermal-preload", {1.0})), 1.01 * plain);
  EXPECT_LT(torque(contact_model_with("ball-material", {1.0})), 0.99 * plain);
  EXPECT_NE(torque(contact_model_with("misalignment", {1.0})), plain);
  EXPECT_NE(torque(contact_model_with("interference-fit", {10.0})), plain);
}

TEST(ContactLawInAModel, HeatOfTheRingsIsThePower) {
  for (const double drag : {0.0, 0.02}) {
    Model model = contact_model();
    model.law_values.back() = drag;
    const FrictionPrediction p = predict_friction(model, fast, {});
    ASSERT_TRUE(p.contacts.has_value());
    const friction::HeatSplit heat = friction::contact::ring_heat(*p.contacts, fast.speed);
    EXPECT_NEAR(heat.inner + heat.outer, p.power_loss, 1e-9 * p.power_loss);
  }
}

TEST(ContactLawInAModel, ShearThinningScalesTheRollingAlone) {
  const FrictionPrediction plain = predict_friction(contact_model(), fast, {});
  const FrictionPrediction thin =
      predict_friction(contact_model_with("shear-thinning", {0.1, 5000.0}), fast, {});
  const double share = std::pow(1.0 + 4.0, -0.1);
  EXPECT_NEAR(thin.viscous, share * plain.viscous, 1e-12 * plain.viscous);
  EXPECT_DOUBLE_EQ(thin.load, plain.load);
}

TEST(ContactLawInAModel, FilmIsHeatedByTheWholePower) {
  const double resistance = 20e-3;  // [K/W]
  const FrictionPrediction p =
      predict_friction(contact_model_with("film-self-heating", {20.0}), fast, {});
  EXPECT_NEAR(p.film.temperature - fast.temperature, resistance * p.power_loss, 1e-6);
}

// A film that took the entered balls at the balance of others was warmed by a bearing of no kind.
TEST(ContactLawInAModel, FilmIsHeatedByTheBallsThatThereAre) {
  Model model = contact_model_with("ball-material", {1.0});
  model.effects.push_back({.description = effects::find("film-self-heating"), .values = {20.0}});
  const FrictionPrediction p = predict_friction(model, fast, {});
  EXPECT_NEAR(p.film.temperature - fast.temperature, 20e-3 * p.power_loss, 1e-6);
}

TEST(ContactLawInAModel, TorqueIsAffineInTheRollingFactor) {
  Model model = contact_model();
  const auto at = [&](double factor) {
    model.law_values[0] = factor;
    return torque(model);
  };
  EXPECT_NEAR(at(2.0) - at(1.0), at(1.0) - at(0.0), 1e-12 * at(1.0));
}

// A row remembers its integrals while only their factors change, and the oil's slope counts too.
TEST(ContactLawInAModel, ARowThatRemembersItsContactsPredictsAsANewOne) {
  Model model = contact_model_with("viscosity-slope", {1.0});
  const Steps steps(model);
  RowPredictor row(model, steps, fast, {});
  const auto agrees = [&](Stage from, const char* changed) {
    const double expected = predict_friction(model, fast, {}).reading;
    EXPECT_NEAR(row.predict(model, steps, from), expected, 1e-12 * expected) << changed;
  };
  agrees(Stage::entry, "nothing");
  for (const auto& [index, value] : {std::pair{0, 1.7},
                                     {1, 3.0},
                                     {0, 0.0},
                                     {0, 0.8},
                                     {1, 0.0},
                                     {1, 1.0},
                                     {2, 0.2},
                                     {4, 6e-8},
                                     {5, 0.02}}) {
    model.law_values[static_cast<std::size_t>(index)] = value;
    agrees(Stage::base,
           friction::parameters(model.law)[static_cast<std::size_t>(index)].name.data());
  }
  model.effects.front().values = {1.2};
  agrees(Stage::entry, "viscosity at 100 C alone");
}

// As a fit does it: a point, both sides of it in each number, another point. A tangent gives the
// film its temperature there, to 2e-3 K of where the contacts were looked at.
TEST(ContactLawInAModel, ARowWhoseFilmWarmsItselfFollowsAFitAsANewOne) {
  Model model = contact_model_with("film-self-heating", {15.0});
  model.effects.push_back({.description = effects::find("misalignment"), .values = {0.5}});
  const Steps steps(model);
  double &resistance = model.effects[0].values[0], &tilt = model.effects[1].values[0],
         &factor = model.law_values[0];
  for (const bearing::OperatingPoint& point :
       {fast, bearing::OperatingPoint{
                  .speed = 200.0 * rpm, .axial_load = 3000.0, .temperature = kelvin(65.0)}}) {
    RowPredictor row(model, steps, point, {});
    double slope = 0.0, expected_slope = 0.0;
    const auto agrees = [&](double& number, double value, Stage from) {
      const double before = number;
      number = value;
      const double fresh = predict_friction(model, point, {}).reading,
                   known = row.predict(model, steps, from);
      EXPECT_NEAR(known, fresh, 2e-7 * fresh) << resistance << ' ' << tilt << ' ' << factor;
      slope = known - slope;
      expected_slope = fresh - expected_slope;
      number = before;
    };
    for (const auto& [r, t, f] : {std::array{15.0, 0.5, 1.0},
                                  {15.0, 0.7, 1.1},
                                  {40.0, 0.7, 0.6},
                                  {41.0, 0.71, 0.61},
                                  {3.0, 0.02, 2.0},
                                  {15.0, 0.5, 1.0}}) {
      resistance = r;
      tilt = t;
      factor = f;
      agrees(resistance, r, Stage::condition);
      for (const auto& [number, step] :
           {std::pair{&factor, 1e-4}, {&resistance, 1.5e-3}, {&tilt, 5e-5}}) {
        const double here = *number;
        agrees(*number, here - step, Stage::condition);
        slope = expected_slope = 0.0;
        agrees(*number, here - step, Stage::condition);
        agrees(*number, here + step, Stage::condition);
        // Slow, the resistance moves less than the integrals are rounded to.
        const double rounding = 1e-9 * row.prediction(model).reading;
        EXPECT_NEAR(slope, expected_slope, 1e-2 * std::abs(expected_slope) + rounding) << here;
        agrees(*number, here, Stage::condition);
      }
    }
  }
}

TEST(ContactLawInAModel, ThermalPreloadTakesThePowerAtTheLoadAsEntered) {
  Model model = contact_model_with("thermal-preload", {1.0});
  const Steps steps(model);
  RowPredictor row(model, steps, fast, {});
  for (const double size : {1.0, 1.5, 1.0, 0.0, 2.0}) {
    model.effects[0].values[0] = size;
    const double expected = predict_friction(model, fast, {}).reading;
    EXPECT_NEAR(row.predict(model, steps, Stage::condition), expected, 1e-9 * expected) << size;
  }
}

TEST(ContactLawInAModel, LimitingTractionIsANumberOfTheLubricant) {
  const std::vector<record::Parameter> all = parameters(contact_model());
  const auto address = [&](std::string_view name) {
    const auto p =
        std::find_if(all.begin(), all.end(), [&](const auto& x) { return x.name == name; });
    return p == all.end() ? std::string("missing") : p->addresses.front();
  };
  EXPECT_EQ(address("limiting_traction"), "lubricant.limiting_traction");
  EXPECT_EQ(address("rolling_factor"), "friction.rolling_factor");
  EXPECT_EQ(default_free(contact_model()), std::vector<std::string>{"rolling_factor"});
}

TEST(ContactLawInAModel, WhatItContainsIsRefusedAndSaysWhatStandsForIt) {
  Model model = contact_model();
  for (const std::string_view id :
       {"spin-friction", "differential-slip", "gyroscopic-slip", "elastic-hysteresis",
        "mixed-lubrication", "inlet-shear-heating", "replenishment-starvation", "viscous-exponent",
        "load-exponent"})
    EXPECT_NE(refused_by_law(*effects::find(id), model), "") << id;
  for (const std::string_view id : {"windage", "seal-friction", "ball-material", "lubricant-drag"})
    EXPECT_EQ(refused_by_law(*effects::find(id), model), "") << id;
  model.law_values.back() = 0.01;
  EXPECT_NE(refused_by_law(*effects::find("lubricant-drag"), model), "");
}

}  // namespace
}  // namespace raceway::fit
