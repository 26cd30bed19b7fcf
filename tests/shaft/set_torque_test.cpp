#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "shaft/set_torque_subject.h"
#include "shaft/shaft_prediction.h"
#include "shaft/torque_rows.h"
#include "tests/support/loop.h"
#include "tests/support/shafts.h"

namespace raceway::fit {

using namespace shaft;

namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

/// Two equal bearings in O.
Model pair_of(Model model, double preload, bearing::Mounting mounting = bearing::Mounting::rigid) {
  const auto one = std::make_shared<const bearing::Bearing>(model.bearing);
  model.shaft = Shaft{bearing::Arrangement({.front = {{one}},
                                            .rear = {{one}},
                                            .mounting = mounting,
                                            .preload = bearing::PreloadForce{preload}})};
  return model;
}

Model single(Model model) {
  model.shaft.reset();
  return model;
}

double torque_at(const Model& model, double speed_rpm, double load, double temperature_C = 40) {
  return predict_torque(model, factorial_plan({speed_rpm}, {load}, {temperature_C})).at(0);
}

/// Torque of one bearing by itself, as raceway solve has it.
double alone(const Model& model, double speed_rpm, double load) {
  return predict_friction(single(model),
                          {.speed = speed_rpm * rpm, .axial_load = load, .temperature = kelvin(40)})
      .torque;
}

// A spring keeps the force of both bearings at every speed.
TEST(SetTorque, OfAPairOnASpringIsTwiceTheTorqueOfOneBearingUnderThePreload) {
  for (Model one : {synthetic_model(), with_effect(synthetic_model(), "spin-friction", {0.06}),
                    contact_model()})
    for (const double speed : {500.0, 6000.0, 12000.0}) {
      const double torque = alone(one, speed, 800);
      EXPECT_NEAR(torque_at(pair_of(one, 800, bearing::Mounting::spring), speed, 0.0), 2.0 * torque,
                  1e-7 * torque)
          << speed;
    }
}

TEST(SetTorque, IsTheSumOverBearingsUnderWhatTheyCarryInTheBalance) {
  for (const Model& model : {pair_of(synthetic_model(), 1500), pair_of(contact_model(), 1500),
                             two_against_one(), two_against_one(contact_model())})
    for (const double load : {-400.0, 0.0, 900.0}) {
      const double speed = 8000.0;
      const bearing::ArrangementEquilibrium sets = bearing::solve_arrangement(
          model.shaft->arrangement, {.speed = speed * rpm, .external_load = load});
      ASSERT_TRUE(sets.report.converged());
      EXPECT_NEAR(sets.rear_force - sets.front_force, load, 1e-5);
      double sum = 0.0;
      for (const bearing::BearingInSet& b : sets.bearings) sum += alone(model, speed, b.axial_load);
      EXPECT_NEAR(torque_at(model, speed, load), sum, 1e-6 * sum) << load;
    }
}

// A rigid pair carries an external load as both springs stiffen and relax: the loads of both are
// not preload and preload + F, and Palmgren's moment tells.
TEST(SetTorque, OfARigidPairGrowsLessThanTheExternalLoad) {
  const Model model = pair_of(synthetic_model(), 1000);
  const double free = torque_at(model, 300, 0.0), loaded = torque_at(model, 300, 500.0);
  EXPECT_GT(loaded, free);
  EXPECT_LT(loaded, alone(model, 300, 1000) + alone(model, 300, 1500));
}

// At rest, where no centrifugal force keeps the balls of the relieved bearing in place.
TEST(SetTorque, OfABearingWithoutContactsIsItsViscousMoment) {
  const Model model = pair_of(synthetic_model(), 200);
  const auto sets =
      bearing::solve_arrangement(model.shaft->arrangement, {.speed = 0, .external_load = 3000});
  ASSERT_TRUE(sets.report.converged());
  ASSERT_TRUE(sets.bearings[0].lost());
  const FrictionPrediction idle =
      predict_friction(single(model), {.speed = 0, .axial_load = 0.0, .temperature = kelvin(40)});
  EXPECT_NEAR(torque_at(model, 0, 3000), alone(model, 0, 3000) + idle.viscous, 1e-7 * idle.viscous);
}

TEST(SetTorque, HasTheEffectsOfTheRigOnceAndThoseOfBearingsForEach) {
  const Model plain = two_against_one();
  const auto with = [&](const char* id, std::vector<double> values) {
    return torque_at(with_effect(plain, id, std::move(values)), 6000, 100.0);
  };
  const double torque = torque_at(plain, 6000, 100.0);
  EXPECT_NEAR(with("torque-offset", {25.0}) - torque, 25 * N_mm, 1e-12);
  EXPECT_NEAR(with("torque-gain", {-0.1}), 0.9 * torque, 1e-12);
  EXPECT_NEAR(
      with("windage", {10.0}) - torque,
      3 * (predict_friction(with_effect(synthetic_model(), "windage", {10.0}),
                            {.speed = 6000 * rpm, .axial_load = 300})
               .torque -
           predict_friction(synthetic_model(), {.speed = 6000 * rpm, .axial_load = 300}).torque),
      1e-12);
  Model thicker = plain;
  thicker.lubricant = friction::Lubricant(33.0 * mm2_per_s, 7.2 * mm2_per_s);
  EXPECT_NEAR(with("lubricant-viscosity", {1.5}), torque_at(thicker, 6000, 100.0), 1e-9 * torque);
  EXPECT_NEAR(with("temperature-offset", {5.0}), torque_at(plain, 6000, 100.0, 35.0),
              1e-9 * torque);
  // A known preload of the record, or a preload that is another one.
  EXPECT_NEAR(
      with("preload-calibration", {1.5}),
      [&] {
        DataSet row = factorial_plan({6000}, {100}, {40});
        row.rows[0].preload = 900;
        return predict_torque(plain, row).at(0);
      }(),
      1e-9 * torque);
}

TEST(SetTorque, OfDragOnTheRotorIsThereOnceWhereTheShaftCoastsDown) {
  Model model = with_effect(two_against_one(), "windage", {10.0});
  const double each = torque_at(model, 6000, 0.0), none = torque_at(two_against_one(), 6000, 0.0);
  model.rig.inertia = 0.01;
  EXPECT_NEAR(torque_at(model, 6000, 0.0) - none, (each - none) / 3, 1e-9 * none);
}

/// Preloads, speeds, loads and temperatures of a rig.
DataSet torque_plan() {
  DataSet data =
      factorial_plan({500, 1500, 3000, 5000, 7000, 9000}, {0, 600, 1500, 3000}, {30, 45, 60});
  data.source = "torque.csv";
  return data;
}

/// With noise of a share of each reading.
DataSet torque_record(const Model& truth, double noise, unsigned seed = 1) {
  DataSet data = torque_plan();
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  const std::vector<double> torque = predict_torque(truth, data);
  for (std::size_t i = 0; i < torque.size(); ++i)
    data.rows[i].measured = torque[i] * (1.0 + noise * gauss(random));
  return data;
}

TEST(SetTorque, IsRememberedWithoutAChangeOfItsNumbers) {
  std::mt19937 random(5);
  for (Model model :
       {with_effect(with_effect(pair_of(contact_model(), 1500), "preload-calibration", {1.0}),
                    "misalignment", {0.0}),
        with_effect(with_effect(two_against_one(), "spin-friction", {0.05}),
                    "centrifugal-ring-growth", {0.0})}) {
    const SetTorqueSubject subject(model);
    const Record data = factorial_plan({500, 7000}, {0, 1500}, {30, 60});
    std::vector<std::string> names;
    for (const Parameter& p : subject.parameters())
      if (p.name != "conformity") names.push_back(p.name);
    const auto predictor = subject.predictor(data, names, subject.prepare(data));
    std::vector<double> values;
    const std::vector<Parameter> numbers = find_parameters(subject, names);
    for (const Parameter& p : numbers) values.push_back(p.start);
    std::vector<double> remembered(data.rows());
    for (int step = 0; step < 12; ++step) {
      const std::size_t k = random() % values.size();
      const Parameter& p = numbers[k];
      values[k] = step % 4 == 3 ? p.start : values[k] + 0.01 * p.scale;
      predictor->readings(values, remembered);
      std::vector<NamedValue> named;
      for (std::size_t i = 0; i < names.size(); ++i) named.push_back({names[i], values[i]});
      const std::vector<double> fresh = predict(*subject.with_values(named), data);
      for (std::size_t i = 0; i < fresh.size(); ++i)
        EXPECT_NEAR(remembered[i], fresh[i], 1e-8 * fresh[i]) << p.name << " step " << step;
    }
  }
}

TEST(SetTorqueSubject, TakesFrictionTorqueAndFreesTheLaw) {
  const SetTorqueSubject subject(two_against_one());
  EXPECT_NO_THROW(subject.require(torque_plan()));
  DataSet displacement = torque_plan();
  displacement.quantity = Quantity::axial_displacement;
  EXPECT_THROW(subject.require(displacement), std::invalid_argument);
  EXPECT_EQ(*subject.measured().at(0).channel, record::friction_torque);
  EXPECT_THAT(subject.free(), ElementsAre("f0", "z"));
  Model model = two_against_one();
  model.free = {"preload_N"};
  EXPECT_THAT(SetTorqueSubject(model).free(), ElementsAre("preload_N"));
  EXPECT_THROW(SetTorqueSubject{synthetic_model()}, std::invalid_argument);
}

TEST(SetTorqueSubject, HasTheCandidatesOfARigAndOfSets) {
  const SetTorqueSubject subject(two_against_one());
  std::vector<std::string> ids;
  for (const Candidate& c : subject.candidates()) ids.push_back(c.id);
  EXPECT_THAT(ids, IsSupersetOf({"torque-offset", "spin-friction", "seal-friction",
                                 "preload-calibration", "mounting", "thermal-preload",
                                 "lubricant-viscosity", "contact-angle", "windage"}));
  for (const char* id : {"displacement-offset", "shaft-contraction", "load-offset", "set-preload"})
    EXPECT_THAT(ids, Not(Contains(id)));
  const Record data = torque_plan();
  EXPECT_THAT(subject.lacks("displacement-offset", data), HasSubstr("axial displacement"));
  EXPECT_THAT(subject.lacks("load-offset", data), HasSubstr("a single bearing on a rig"));
  EXPECT_THAT(subject.lacks("seal-friction", data), IsEmpty());
  EXPECT_THAT(subject.lacks("misalignment", data), HasSubstr("ball loads"));
  EXPECT_THAT(SetTorqueSubject(two_against_one(contact_model())).lacks("misalignment", data),
              IsEmpty());
  const std::vector<std::string> wrong{"displacement-offset"};
  EXPECT_THROW((void)subject.with_candidates(wrong), std::invalid_argument);
  std::vector<std::string> laws;
  for (const OtherBase& base : subject.other_bases()) laws.push_back(base.id);
  EXPECT_THAT(laws, Contains("law:skf"));
}

TEST(SetTorqueSubject, FindsThePreloadWithTheNumbersOfTheLaw) {
  const DataSet data = torque_record(pair_of(synthetic_model(), 1500), 0.01);
  Model model = pair_of(synthetic_model(), 700);
  model.law_values = {1.1, 0.0013, 0.33};
  model.free = {"f0", "z", "preload_N"};
  const verdict::Calibration found = loop::calibrate(SetTorqueSubject(model), data);
  ASSERT_TRUE(found.converged());
  const std::vector<double> truth{1.5, 0.001, 1500.0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Parameter& p = found.parameters[k];
    EXPECT_NEAR(p.value, truth[k], 3.0 * p.std) << p.name;
    EXPECT_LT(p.std, 0.05 * truth[k]) << p.name;
  }
}

TEST(SetTorqueSubject, DiagnosesAPreloadThatIsAnotherOneThanEntered) {
  const DataSet data = torque_record(pair_of(synthetic_model(), 1200), 0.01);
  const verdict::Diagnosis found =
      loop::diagnose(SetTorqueSubject(pair_of(synthetic_model(), 900)), data);
  EXPECT_EQ(found.verdict, verdict::Verdict::effect) << found.sentence;
  EXPECT_THAT(found.sentence, HasSubstr("heck the preload"));
}

TEST(SetTorqueSubject, DiagnosesAnEffectOfFriction) {
  const DataSet data = torque_record(
      with_effect(pair_of(synthetic_model(), 1500), "seal-friction", {40.0, 0.01}), 0.01);
  const verdict::Diagnosis found =
      loop::diagnose(SetTorqueSubject(pair_of(synthetic_model(), 1500)), data);
  EXPECT_NE(found.verdict, verdict::Verdict::nothing_missing) << found.sentence;
  EXPECT_THAT(found.sentence, HasSubstr("seal"));
}

}  // namespace
}  // namespace raceway::fit
