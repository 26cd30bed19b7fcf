// What holds of hundreds of samples: that probabilities and standard errors are what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/loop.h"
#include "tests/support/synthetic.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"

namespace raceway::fit {
namespace {

const std::vector<double> speeds{500, 1500, 3000, 5000, 7500, 10000, 12500, 15000};

/// Largest distance of sorted p-values from the uniform distribution (Kolmogorov's D).
double distance_from_uniform(std::vector<double> p) {
  std::sort(p.begin(), p.end());
  double distance = 0.0;
  const auto n = static_cast<double>(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    distance = std::max(distance, std::abs(p[i] - static_cast<double>(i) / n));
    distance = std::max(distance, std::abs(p[i] - static_cast<double>(i + 1) / n));
  }
  return distance;
}

TEST(Compare, FindsNoStructureInPureNoiseMoreOftenThanItSays) {
  const Model truth = synthetic_model();
  for (const NoiseSource source : {NoiseSource::declared, NoiseSource::repeats}) {
    std::mt19937 random(30);
    std::vector<double> p, fitted;
    for (int set = 0; set < 400; ++set) {
      const bool declared = source == NoiseSource::declared;
      DataSet data = factorial_plan(speeds, {100, 300, 600}, {25, 60}, declared ? 1 : 3);
      measure(truth, 2.0 * N_mm, random, data);
      if (declared) declare_noise(2.0 * N_mm, data);
      const verdict::Comparison c = compare(truth, data);
      EXPECT_EQ(c.noise.source, source);
      p.push_back(c.lack_of_fit.p_value);
      fitted.push_back(compare(model_of(calibrate(truth, data)), data, 2).lack_of_fit.p_value);
    }
    // Kolmogorov's 1 % point is 1.63/sqrt(400) = 0.08.
    EXPECT_LT(distance_from_uniform(p), 0.08);
    EXPECT_LT(distance_from_uniform(fitted), 0.08) << name(source);
  }
}

TEST(Compare, FindsAPatternInPureNoiseNoMoreOftenThanItSays) {
  const Model truth = synthetic_model();
  std::mt19937 random(31);
  int alarms = 0, unknown = 0;
  for (int set = 0; set < 1000; ++set) {
    DataSet data = factorial_plan(speeds, {100, 300, 600}, {25, 60});
    measure(truth, 2.0 * N_mm, random, data);
    const verdict::Comparison c = compare(model_of(calibrate(truth, data)), data, 2);
    EXPECT_EQ(c.pattern.pairs, 42);
    if (c.pattern.p_value < 0.05) ++alarms;
    if (c.judgement == verdict::Judgement::unknown) ++unknown;
  }
  EXPECT_LT(alarms, 75);  // 50 +- 7 expected
  EXPECT_GT(unknown, 970);
}

TEST(Calibrate, StatesAnUncertaintyThatCoversTheTruth) {
  Model truth = synthetic_model();
  truth.law_values = {2.0, 0.0012, 0.35};
  Model model = synthetic_model();
  model.free = {"f0", "z", "y"};
  for (const bool declared : {false, true}) {
    std::mt19937 random(20);
    constexpr int sets = 200;
    std::vector<double> square(3, 0.0);
    int inside = 0;
    for (int set = 0; set < sets; ++set) {
      DataSet data = factorial_plan(speeds, {100, 300, 600, 1200}, {25, 40, 60});
      measure(truth, 3.0 * N_mm, random, data);
      if (declared) declare_noise(3.0 * N_mm, data);
      const verdict::Calibration fit = calibrate(model, data);
      ASSERT_TRUE(fit.converged());
      EXPECT_TRUE(std::isfinite(fit.reduced_chi_square));
      for (std::size_t k = 0; k < 3; ++k) {
        const Parameter& p = fit.parameters[k];
        const double t = (p.value - truth.law_values[k]) / p.std;
        square[k] += t * t / sets;
        if (std::abs(t) < 1.96) ++inside;
      }
    }
    // Mean square of 200 normal deviates: 1 +- 0.1; widening by sqrt(chi2) when it exceeds 1 is
    // mild.
    for (const double s : square) EXPECT_NEAR(s, 1.0, 0.3);
    EXPECT_NEAR(inside / (3.0 * sets), 0.95, 0.03);
  }
}

}  // namespace
}  // namespace raceway::fit
