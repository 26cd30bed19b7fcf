#include "verdict/estimated_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

DataSet plan() {
  return factorial_plan({600, 1500, 3500, 7000, 11000, 16000}, {250, 600, 1400, 3000},
                        {25, 40, 55});
}

TEST(EstimatedNoise, IsThatOfTheReadingsHoweverWrongTheModel) {
  Model truth = synthetic_model();
  truth.effects.push_back({.description = effects::find("lubricant-drag"), .values = {60.0}});
  DataSet data = plan();
  std::mt19937 random(11);
  measure(truth, 5.0 * N_mm, random, data);
  const auto channels = verdict::estimate_noise_as_diagnosis(*subject_of(synthetic_model()), data);
  ASSERT_TRUE(channels);
  const verdict::EstimatedNoise* noise = &channels->front();
  // About 40 degrees of freedom remain of 72 rows: 11 % of scatter, three times that.
  EXPECT_NEAR(noise->rms, 5.0 * N_mm, 1.7 * N_mm);
  ASSERT_EQ(noise->std.size(), data.rows.size());
  EXPECT_TRUE(std::all_of(noise->std.begin(), noise->std.end(), [](double s) { return s > 0.0; }));
}

TEST(EstimatedNoise, IsThereForRowsThatADiagnosisOfManyLeavesOut) {
  std::vector<double> speeds, loads;
  for (int k = 0; k < 60; ++k) speeds.push_back(600.0 + 250.0 * k);
  for (int k = 0; k < 25; ++k) loads.push_back(250.0 + 100.0 * k);
  DataSet data = factorial_plan(speeds, loads, {25, 40, 55});
  std::mt19937 random(5);
  measure(synthetic_model(), 5.0 * N_mm, random, data);
  ASSERT_GT(data.rows.size(), 4000U);
  const auto channels = verdict::estimate_noise_as_diagnosis(*subject_of(synthetic_model()), data);
  ASSERT_TRUE(channels);
  const verdict::EstimatedNoise* noise = &channels->front();
  // A row beyond 3.5 standard deviations has its own: 2 of 4500 by chance.
  const auto others = std::count_if(noise->std.begin(), noise->std.end(), [](double s) {
    return !(std::abs(s - 5.0 * N_mm) < 1.0 * N_mm);
  });
  EXPECT_LE(others, 8);
}

TEST(EstimatedNoise, IsNothingWhereTheDataCannotCarryADiagnosis) {
  DataSet data = plan();
  std::mt19937 random(11);
  measure(synthetic_model(), 5.0 * N_mm, random, data);
  data.rows.resize(6);
  EXPECT_FALSE(verdict::estimate_noise_as_diagnosis(*subject_of(synthetic_model()), data));
  data = plan();
  data.quantity = Quantity::axial_displacement;
  EXPECT_FALSE(verdict::estimate_noise_as_diagnosis(*subject_of(synthetic_model()), data));
}

}  // namespace
}  // namespace raceway::fit
