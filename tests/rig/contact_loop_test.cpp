#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "effects/catalogue.h"
#include "loop/loop.h"
#include "rig/rig_subject.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

using rig::RigSubject;
using testing::Contains;
using testing::HasSubstr;

Model contacts(std::vector<std::string> free) {
  Model model = synthetic_model();
  model.law = friction::FrictionLaw::contact;
  model.law_values.clear();
  for (const friction::Parameter& p : friction::parameters(model.law))
    model.law_values.push_back(p.initial);
  model.free = std::move(free);
  return model;
}

DataSet rows(const std::vector<double>& speeds, const Model& truth) {
  DataSet data = factorial_plan(speeds, {250, 500, 1000}, {30, 40, 50});
  std::mt19937 random(3);
  measure(truth, 2.0 * N_mm, random, data);
  return data;
}

TEST(ContactLoop, FrictionOfAsperitiesAsksForThinFilms) {
  const Model model = contacts({"mu_boundary"});
  const verdict::Calibration fast =
      loop::calibrate(RigSubject(model), rows({6000, 9000, 12000}, model));
  EXPECT_FALSE(fast.parameters[0].identifiable);
  EXPECT_EQ(fast.parameters[0].value, 0.10);
  EXPECT_THAT(texts(fast.messages),
              Contains(HasSubstr(
                  "mu_boundary needs rows with a film ratio lambda < 2; the smallest lambda in "
                  "this record is ")));
  const verdict::Calibration slow =
      loop::calibrate(RigSubject(model), rows({5, 10, 20, 50}, model));
  EXPECT_TRUE(slow.parameters[0].identifiable);
  EXPECT_THAT(texts(slow.messages), testing::Not(Contains(HasSubstr("lambda"))));
}

TEST(ContactLoop, TheLimitOfTheFilmAsksForHighPressure) {
  const Model model = contacts({"limiting_traction"});
  const verdict::Calibration c =
      loop::calibrate(RigSubject(model), rows({6000, 9000, 12000}, model));
  EXPECT_EQ(c.status, FitStatus::nothing_to_fit);
  EXPECT_THAT(
      texts(c.messages),
      Contains(testing::AllOf(
          HasSubstr("these data do not determine limiting_traction"), HasSubstr("less than 0.1 %"),
          HasSubstr("the largest pressure in this record is "), HasSubstr(" GPa"))));
}

/// A tilt acts with its square: what is told from no tilt lies far beyond all that it can be.
TEST(ContactLoop, WhatWouldHaveBeenFoundLiesWithinTheRangeOfItsParameter) {
  Model model = contacts({"rolling_factor"});
  const DataSet data = rows({600, 2000, 6000, 9000, 12000}, model);
  const verdict::Diagnosis d = loop::diagnose(RigSubject(model), data);
  ASSERT_EQ(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
  double tilt = 0.0;
  for (const verdict::DetectableSize& s : d.would_have_been_found) {
    const effects::Description* const e = effects::find(s.id);
    ASSERT_NE(e, nullptr) << s.id;
    for (const effects::Parameter& p : e->parameters)
      if (p.name == s.parameter) {
        EXPECT_GE(s.size, p.lower) << s.id;
        EXPECT_LE(s.size, p.upper) << s.id;
      }
    if (s.id == "misalignment") tilt = s.size;
  }
  ASSERT_GT(tilt, 0.0);
  model.effects.push_back(
      {.description = effects::find("misalignment"), .values = {std::min(1.3 * tilt, 3.0)}});
  EXPECT_NE(loop::diagnose(RigSubject(contacts({"rolling_factor"})),
                           rows({600, 2000, 6000, 9000, 12000}, model))
                .verdict,
            verdict::Verdict::nothing_missing);
}

}  // namespace
}  // namespace raceway::fit
