#include "shaft/shaft_subject.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/shaft/shaft_records.h"

namespace raceway::fit {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

std::vector<std::string> ids(const Subject& subject) {
  std::vector<std::string> list;
  for (const Candidate& c : subject.candidates()) list.push_back(c.id);
  return list;
}

const Axis& axis(const std::vector<Axis>& axes, const record::Channel& channel) {
  return *std::find_if(axes.begin(), axes.end(),
                       [&](const Axis& a) { return *a.channel == channel; });
}

TEST(ShaftSubject, PredictsTheDisplacementOfItsModel) {
  const Model model = with_effect(two_against_one(), "displacement-offset", {1.5});
  const Record record = shaft_plan(ShaftPlan::up_and_down);
  EXPECT_EQ(predict(ShaftSubject(model), record), predict_displacement(model, record));
}

TEST(ShaftSubject, TakesTheExternalLoadOfTheModelWhereNoneWasRecorded) {
  Model model = two_against_one();
  model.shaft->external_load = -150.0;
  DataSet data = shaft_plan(ShaftPlan::sweep);
  Record without = data;
  std::erase_if(without.columns,
                [](const record::Column& c) { return *c.channel == record::axial_load; });
  for (Row& row : data.rows) row.point.axial_load = -150.0;
  EXPECT_EQ(predict(ShaftSubject(model), without), predict(ShaftSubject(model), data));
}

TEST(ShaftSubject, HasNoReadingWhereARowLacksSpeedOrLoad) {
  DataSet data = shaft_plan(ShaftPlan::sweep);
  data.rows[3].point.speed = unset;
  data.rows[5].point.axial_load = unset;
  const std::vector<double> u = predict(ShaftSubject(two_against_one()), data);
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_EQ(std::isnan(u[i]), i == 3 || i == 5) << i;
}

TEST(ShaftSubject, SaysWhichTemperatureCannotBe) {
  DataSet data = shaft_plan(ShaftPlan::sweep);
  data.rows[3].inner_ring_temperature = 1.0;
  try {
    (void)predict(ShaftSubject(two_against_one()), data);
    FAIL() << "1 K";
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(), HasSubstr("inner_ring"));
  }
}

TEST(ShaftSubject, HasCandidatesThatMoveIt) {
  const ShaftSubject subject(two_against_one());
  EXPECT_THAT(ids(subject), IsSupersetOf({"mounting", "displacement-offset", "thermal-preload"}));
  EXPECT_THAT(ids(subject), Not(Contains("seal-friction")));
  EXPECT_THAT(subject.catalogue(), Contains("seal-friction"));
  const std::vector<std::string> friction{"seal-friction"};
  try {
    (void)subject.with_candidates(friction);
    FAIL() << "seal friction moves no shaft";
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(),
                 "seal-friction: this effect does not change the measured axial displacement");
  }
  EXPECT_THAT(subject.lacks("seal-friction", shaft_plan(ShaftPlan::sweep)),
              HasSubstr("friction torque"));
  EXPECT_THAT(subject.lacks("thermal-ring-growth", shaft_plan(ShaftPlan::sweep)),
              HasSubstr("inner_ring_temperature_C"));
  EXPECT_THAT(subject.lacks("thermal-ring-growth", shaft_plan(ShaftPlan::up_and_down)), IsEmpty());
  EXPECT_THAT(subject.lacks_levels("mounting", shaft_plan(ShaftPlan::sweep)),
              HasSubstr("preload_N"));
}

TEST(ShaftSubject, SetsTheNumbersOfItsArrangement) {
  const ShaftSubject subject(two_against_one());
  EXPECT_THAT(subject.free(), ElementsAre("preload_N"));
  const std::vector<NamedValue> values{{"preload_N", 450.0}, {"conformity", 0.53}};
  const auto other = subject.with_values(values);
  EXPECT_NEAR(model::model_of(*other).shaft->arrangement.preload(), 450.0, 1e-9);
  EXPECT_EQ(model::model_of(*other).bearing.geometry().outer_conformity, 0.53);
  const std::vector<NamedValue> wrong{{"preload", 450.0}};
  EXPECT_THROW((void)subject.with_values(wrong), std::invalid_argument);
  const std::vector<NamedValue> none{{"contact_angle_deg", 120.0}};
  EXPECT_THROW((void)subject.with_values(none), std::invalid_argument);
  EXPECT_THROW(ShaftSubject{synthetic_model()}, std::invalid_argument);
}

TEST(ShaftSubject, TakesDisplacementAlone) {
  const ShaftSubject subject(two_against_one());
  EXPECT_NO_THROW(subject.require(shaft_plan(ShaftPlan::sweep)));
  DataSet torque = shaft_plan(ShaftPlan::sweep);
  torque.quantity = Quantity::friction_torque;
  EXPECT_THROW(subject.require(torque), std::invalid_argument);
  EXPECT_EQ(*subject.measured().at(0).channel, record::axial_displacement);
}

TEST(ShaftSubject, DoubtsUnitAndSign) {
  const ShaftSubject subject(two_against_one());
  const DataSet truth = shaft_records(two_against_one(), ShaftPlan::sweep);
  const std::vector<double> predicted = predict(subject, truth);
  EXPECT_THAT(subject.doubt(truth, predicted), IsEmpty());
  DataSet data = truth;
  for (Row& row : data.rows) row.measured *= 1e-3;
  EXPECT_THAT(subject.doubt(data, predicted), HasSubstr("in um?"));
  for (Row& row : data.rows) row.measured *= -1e3;
  EXPECT_THAT(subject.doubt(data, predicted), HasSubstr("the sign of"));
}

TEST(ShaftSubject, ProposesOtherPreloads) {
  const ShaftSubject subject(two_against_one());
  const std::vector<Axis> plain = subject.axes(shaft_plan(ShaftPlan::sweep));
  EXPECT_EQ(axis(plain, record::speed).levels.size(), 7U);
  EXPECT_EQ(axis(plain, record::axial_load).levels, std::vector{0.0});
  EXPECT_FALSE(axis(plain, record::axial_load).told);
  const std::vector<double>& one = axis(plain, record::preload).levels;
  ASSERT_EQ(one.size(), 3U);
  EXPECT_TRUE(std::isnan(one[0])) << "as it is";
  EXPECT_NEAR(one[1], 300.0, 1e-9);
  EXPECT_NEAR(one[2], 1200.0, 1e-9);
  const std::vector<Axis> two = subject.axes(shaft_plan(ShaftPlan::two_preloads));
  EXPECT_THAT(axis(two, record::preload).levels, ElementsAre(300.0, 600.0, 900.0));
}

TEST(ShaftSubject, PutsPointsInWords) {
  const ShaftSubject subject(two_against_one());
  EXPECT_EQ(
      subject.words(std::vector<Setting>{{&record::speed, 995 * rpm}, {&record::preload, 300.0}}),
      "995 rpm at a preload of 300 N");
  EXPECT_EQ(
      subject.words(std::vector<Setting>{{&record::speed, 995 * rpm}, {&record::preload, unset}}),
      "995 rpm");
  EXPECT_EQ(
      subject.words(std::vector<Setting>{
          {&record::speed, 995 * rpm}, {&record::axial_load, -100.0}, {&record::preload, 300.0}}),
      "995 rpm, -100 N external load at a preload of 300 N");
}

TEST(ShaftSubject, AsksForTemperaturesWhereHeatAndSpeedAreRivals) {
  const ShaftSubject subject(two_against_one());
  const Record plain = shaft_plan(ShaftPlan::sweep), warm = shaft_plan(ShaftPlan::up_and_down);
  const std::vector<std::vector<std::string>> rivals{{"centrifugal-ring-growth"},
                                                     {"thermal-preload"}};
  EXPECT_THAT(subject.records_needed(plain, rivals, {}),
              ElementsAre(HasSubstr("ring temperatures"), HasSubstr("up and down")));
  EXPECT_THAT(subject.records_needed(warm, rivals, {}), ElementsAre(HasSubstr("up and down")));
  EXPECT_THAT(subject.records_needed(plain, {{"mounting"}, {"centrifugal-ring-growth"}}, {}),
              IsEmpty());
  EXPECT_THAT(subject.records_needed(plain, {{"mounting"}, {"centrifugal-ring-growth"}},
                                     {"thermal-ring-growth"}),
              Not(IsEmpty()));
}

TEST(ShaftSubject, SaturatesWithAPolynomialInSpeedAndItsOwnLevels) {
  const ShaftSubject subject(two_against_one());
  const Saturation s = subject.saturation(shaft_plan(ShaftPlan::two_preloads));
  EXPECT_THAT(s.levels, ElementsAre(&record::speed, &record::axial_load, &record::preload));
  EXPECT_FALSE(s.levels_before_candidates);
  EXPECT_FALSE(s.proportional);
  EXPECT_THAT(subject.saturation(shaft_plan(ShaftPlan::sweep)).levels,
              ElementsAre(&record::speed, &record::axial_load));
}

TEST(ShaftSubject, BendsLawsBySpeedPreloadAndViscosity) {
  const ShaftSubject subject(two_against_one());
  const std::vector<Factor> factors = subject.factors(shaft_plan(ShaftPlan::two_preloads));
  ASSERT_EQ(factors.size(), 3U);
  EXPECT_EQ(factors[1].name, "preload");
  EXPECT_EQ(factors[1].values.front(), 300.0);
  EXPECT_EQ(subject.factors(shaft_plan(ShaftPlan::sweep))[1].values.front(), 0.0);
}

TEST(ShaftSubject, TellsAReaderOfLoadsThatMayPullAndOfTemperaturesInPairs) {
  Model model = two_against_one();
  model.shaft->external_load = -20.0;
  const Expected expected = ShaftSubject(model).expected();
  EXPECT_THAT(expected.signed_inputs, ElementsAre(&record::axial_load));
  const auto load =
      std::find_if(expected.defaults.begin(), expected.defaults.end(),
                   [](const Expected::Default& d) { return *d.channel == record::axial_load; });
  ASSERT_NE(load, expected.defaults.end());
  EXPECT_EQ(load->value, -20.0);
  EXPECT_EQ(load->from, "external_load_N of [arrangement]");
  EXPECT_EQ(expected.partners.size(), 2U);
  EXPECT_EQ(expected.measured.front(), &record::axial_displacement);
}

}  // namespace
}  // namespace raceway::fit
