#include "fit/verdict_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "tests/fit/synthetic.h"

namespace raceway::fit {
namespace {

constexpr double drag = 60.0;  // N mm at 10 000 rpm

struct Case {
  Model belief = synthetic_model();
  DataSet data =
      factorial_plan({600, 1500, 3500, 7000, 11000, 16000}, {250, 600, 1400, 3000}, {25, 40, 55});
  Diagnosis diagnosis;
  explicit Case(double drag_size, int most_rows = most_rows_of_a_fit) {
    Model truth = synthetic_model();
    truth.effects.push_back(
        {.description = effects::find("lubricant-drag"), .values = {drag_size}});
    std::mt19937 random(3);
    measure(truth, 1.0 * N_mm, random, data);
    belief.law_values = {2.0, 0.0008, 0.33};
    DiagnoseOptions options;
    options.pairs = false;
    options.most_rows = most_rows;
    diagnosis = diagnose(belief, data, options);
  }
};

TEST(VerdictModel, PredictsWhatTheDiagnosisFoundAndSplitsIt) {
  const Case c(drag);
  ASSERT_EQ(c.diagnosis.verdict, Verdict::effect) << c.diagnosis.sentence;
  const auto v = verdict_model(c.belief, c.data, c.diagnosis);
  ASSERT_TRUE(v);
  ASSERT_EQ(v->effects.size(), 1U);
  EXPECT_EQ(v->effects[0].id, "lubricant-drag");
  const double size = c.diagnosis.effects[0].parameters[0].value;
  double square = 0.0;
  for (std::size_t i = 0; i < c.data.rows.size(); ++i) {
    const Row& row = c.data.rows[i];
    // The effect by its formula, which nothing here has computed.
    const double n = row.point.speed / (10000 * rpm);
    EXPECT_NEAR(v->effects[0].readings[i], size * n * n * N_mm, 1e-9);
    EXPECT_NEAR(v->base[i] + v->effects[0].readings[i], v->readings[i], 1e-12);
    square += std::pow(v->readings[i] - row.measured, 2);
  }
  EXPECT_NEAR(std::sqrt(square / static_cast<double>(c.data.rows.size())), c.diagnosis.rmse_after,
              1e-6 * c.diagnosis.rmse_after);
}

TEST(VerdictModel, EveryRankedEffectHasItsBaseParametersAndItsShare) {
  const Case c(drag);
  ASSERT_GE(c.diagnosis.effects.size(), 5U);
  for (const RankedEffect& e : c.diagnosis.effects) {
    ASSERT_EQ(e.base_shifts.size(), 2U) << e.id;
    const auto with = model_with(e, c.belief, c.data, c.diagnosis);
    ASSERT_TRUE(with) << e.id;
    ASSERT_EQ(with->effects.size(), 1U);
    EXPECT_EQ(with->effects[0].id, e.id);
    // The base part by a model of these parameters in which the effect never was.
    Model base = c.belief;
    base.law_values[0] = e.base_shifts[0].after;
    base.law_values[1] = e.base_shifts[1].after;
    const std::vector<FrictionPrediction> alone = predict_rows(base, c.data);
    double square = 0.0;
    for (std::size_t i = 0; i < c.data.rows.size(); ++i) {
      EXPECT_NEAR(with->base[i], alone[i].reading, 1e-9 * alone[i].reading) << e.id;
      EXPECT_NEAR(with->base[i] + with->effects[0].readings[i], with->readings[i], 1e-12) << e.id;
      square += std::pow(with->readings[i] - c.data.rows[i].measured, 2);
    }
    EXPECT_NEAR(std::sqrt(square / static_cast<double>(c.data.rows.size())), e.rmse, 1e-4 * e.rmse);
  }
  EXPECT_EQ(c.diagnosis.effects[0].base_shifts[0].after, c.diagnosis.base_shifts[0].after);
}

TEST(VerdictModel, OfSomeRowsIsHeldAgainstAll) {
  const Case c(drag, 40);
  ASSERT_EQ(c.diagnosis.rows, 36);
  ASSERT_EQ(c.diagnosis.verdict, Verdict::effect) << c.diagnosis.sentence;
  const auto errors = errors_on_all_rows(c.belief, c.data, c.diagnosis);
  ASSERT_TRUE(errors);
  EXPECT_EQ(errors->rows, 72);
  EXPECT_NEAR(errors->after, 1.0 * N_mm, 0.3 * N_mm);  // the noise
  EXPECT_NEAR(errors->before, c.diagnosis.rmse_before, 0.3 * c.diagnosis.rmse_before);
  ASSERT_FALSE(c.diagnosis.messages.empty());
  EXPECT_NE(c.diagnosis.messages.back().find("over all 72 rows"), std::string::npos);
}

TEST(VerdictModel, IsNothingWhereNothingIsMissing) {
  const Case c(0.0);
  ASSERT_EQ(c.diagnosis.verdict, Verdict::nothing_missing) << c.diagnosis.sentence;
  EXPECT_FALSE(verdict_model(c.belief, c.data, c.diagnosis));
}

TEST(VerdictModel, RefusesNumbersThatDoNotGiveTheErrorOfTheDiagnosis) {
  Case c(drag);
  c.diagnosis.effects[0].parameters[0].value *= 1.1;  // as a bent law would
  EXPECT_FALSE(verdict_model(c.belief, c.data, c.diagnosis));
  EXPECT_FALSE(model_with(c.diagnosis.effects[0], c.belief, c.data, c.diagnosis));
}

}  // namespace
}  // namespace raceway::fit
