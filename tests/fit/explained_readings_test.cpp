#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"
#include "verdict/diagnose.h"

namespace raceway::fit {
namespace {

constexpr double full_drag = 60.0;  // N mm at 10 000 rpm

struct Case {
  Model belief = synthetic_model();
  DataSet data =
      factorial_plan({600, 1500, 3500, 7000, 11000, 16000}, {250, 600, 1400, 3000}, {25, 40, 55});
  verdict::Diagnosis diagnosis;
  explicit Case(double drag_size, int most_rows = verdict::most_rows_of_a_fit) {
    Model truth = synthetic_model();
    truth.effects.push_back(
        {.description = effects::find("lubricant-drag"), .values = {drag_size}});
    std::mt19937 random(3);
    measure(truth, 1.0 * N_mm, random, data);
    belief.law_values = {2.0, 0.0008, 0.33};
    verdict::DiagnoseOptions options;
    options.pairs = false;
    options.most_rows = most_rows;
    diagnosis = diagnose(belief, data, options);
  }
};

/// Readings of the rows as a diagnosis took them.
double measured(const verdict::Diagnosis& d, std::size_t i) {
  return d.channels[0].baseline.errors[i].measured;
}

TEST(ExplainedReadings, AreWhatTheVerdictPredictsAndItsParts) {
  const Case c(full_drag);
  const verdict::Diagnosis& d = c.diagnosis;
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  ASSERT_TRUE(d.verdict_is_explained);
  const verdict::ExplainedReadings& explained = d.explained.front();
  ASSERT_EQ(explained.effects.size(), 1U);
  EXPECT_EQ(explained.effects[0].id, "lubricant-drag");
  const double size = d.effects[0].parameters[0].value;
  double square = 0.0;
  for (std::size_t i = 0; i < c.data.rows.size(); ++i) {
    // The effect by its formula, which nothing here has computed.
    const double n = c.data.rows[d.channels[0].baseline.errors[i].row].point.speed / (10000 * rpm);
    EXPECT_NEAR(explained.effects[0].readings[i], size * n * n * N_mm, 1e-9);
    EXPECT_NEAR(explained.base[i] + explained.effects[0].readings[i], explained.total[i], 1e-12);
    square += std::pow(explained.total[i] - measured(d, i), 2);
  }
  EXPECT_NEAR(std::sqrt(square / static_cast<double>(c.data.rows.size())), d.channels[0].rmse_after,
              1e-9 * d.channels[0].rmse_after);
}

TEST(ExplainedReadings, AreThereForEveryRankedEffect) {
  const Case c(full_drag);
  const verdict::Diagnosis& d = c.diagnosis;
  ASSERT_GE(d.effects.size(), 5U);
  ASSERT_EQ(d.explained.size(), d.effects.size());
  for (std::size_t k = 0; k < d.effects.size(); ++k) {
    const verdict::RankedEffect& e = d.effects[k];
    const verdict::ExplainedReadings& with = d.explained[k];
    ASSERT_EQ(e.base.size(), 2U) << e.id;
    ASSERT_EQ(with.effects.size(), 1U);
    EXPECT_EQ(with.effects[0].id, e.id);
    // The base part by a model of these parameters in which the effect never was.
    Model base = c.belief;
    base.law_values[0] = e.base[0].value;
    base.law_values[1] = e.base[1].value;
    const std::vector<FrictionPrediction> alone = predict_rows(base, c.data);
    double square = 0.0;
    for (std::size_t i = 0; i < c.data.rows.size(); ++i) {
      const double reading = alone[d.channels[0].baseline.errors[i].row].reading;
      EXPECT_NEAR(with.base[i], reading, 1e-9 * reading) << e.id;
      EXPECT_NEAR(with.base[i] + with.effects[0].readings[i], with.total[i], 1e-12) << e.id;
      square += std::pow(with.total[i] - measured(d, i), 2);
    }
    EXPECT_NEAR(std::sqrt(square / static_cast<double>(c.data.rows.size())), e.rmse[0],
                1e-9 * e.rmse[0]);
  }
  EXPECT_EQ(d.effects[0].base[0].value, d.base[0].value);
}

// Lines of a file are for messages: rows made in code have none, and lose nothing by it.
TEST(ExplainedReadings, DoNotNeedLinesOfAFile) {
  Case c(full_drag);
  for (Row& row : c.data.rows) row.line = 0;
  const verdict::Diagnosis d = diagnose(c.belief, c.data);
  ASSERT_EQ(d.verdict, verdict::Verdict::effect);
  EXPECT_EQ(d.explained.front().effects[0].readings,
            c.diagnosis.explained.front().effects[0].readings);
}

TEST(Diagnose, HoldsTheNumbersOfSomeRowsAgainstAll) {
  const Case c(full_drag, 40);
  ASSERT_EQ(c.diagnosis.rows, 40);
  ASSERT_EQ(c.diagnosis.verdict, verdict::Verdict::effect) << c.diagnosis.sentence;
  ASSERT_FALSE(c.diagnosis.messages.empty());
  EXPECT_NE(c.diagnosis.messages.back().text.find("on all 72 rows"), std::string::npos);
}

TEST(ExplainedReadings, AreNotThereWhereNothingIsMissing) {
  const Case c(0.0);
  ASSERT_EQ(c.diagnosis.verdict, verdict::Verdict::nothing_missing) << c.diagnosis.sentence;
  EXPECT_TRUE(c.diagnosis.explained.empty());
}

}  // namespace
}  // namespace raceway::fit
