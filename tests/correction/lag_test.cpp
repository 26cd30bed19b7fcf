#include "correction/lag.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "tests/correction/reference.h"

namespace raceway::correction {
namespace {

Clock clock_of(const std::vector<double>& times) {
  Clock clock;
  for (std::size_t k = 0; k < times.size(); ++k) {
    clock.steps.push_back(k == 0 ? 0.0 : times[k] - times[k - 1]);
    clock.begins.push_back(k == 0);
  }
  return clock;
}

std::vector<double> lagged(const Clock& clock, const std::vector<double>& input, Hold hold,
                           double time_constant, double start = 0.0) {
  std::vector<double> state(input.size());
  lag_response(clock, input, hold, time_constant, start, state);
  return state;
}

TEST(LagStep, HasThePublishedWeights) {
  for (const char* name : {"foh_tau900_dt10", "foh_tau5400_dt60"}) {
    const auto known = reference(name);
    const double ratio = known["dt_s"].get<double>() / known["tau_s"].get<double>();
    const LagStep step = lag_step(ratio, Hold::straight);
    EXPECT_NEAR(step.decay, known["a"], 1e-12);
    EXPECT_NEAR(step.old_weight, known["weight_of_old_input"], 1e-12);
    EXPECT_NEAR(step.new_weight, known["weight_of_new_input"], 1e-12);
    EXPECT_NEAR(lag_step(ratio, Hold::held).old_weight, known["zoh_weight"], 1e-12);
  }
}

/// A constant input arrives whole, whatever the step; and the two forms of the weight meet.
TEST(LagStep, KeepsItsDigitsWhereTheStepIsShort) {
  for (const double ratio : {1e-12, 1e-6, 9.999e-3, 1.0001e-2, 1.0, 50.0}) {
    const LagStep step = lag_step(ratio, Hold::straight);
    EXPECT_NEAR(step.decay + step.old_weight + step.new_weight, 1.0, 1e-15);
    // 1 - (1 - exp(-x))/x in long double
    const long double x = ratio, weight = 1.0L + std::expm1(-x) / x;
    EXPECT_NEAR(step.new_weight / static_cast<double>(weight), 1.0, ratio < 1e-4 ? 1e-6 : 1e-12);
    if (ratio < 1e-4) {
      EXPECT_NEAR(step.new_weight / (ratio / 2.0), 1.0, ratio);
    }
  }
}

TEST(Lag, AnswersAnUnevenClockAsTheReference) {
  const auto known = reference("foh_uneven");
  const std::vector<double> input = numbers(known["u"]);
  std::vector<double> sum(input.size());
  for (std::size_t k = 0; k < input.size(); ++k)
    sum[k] = known["feedthrough"].get<double>() * input[k];
  const Clock clock = clock_of(numbers(known["time_s"]));
  for (const auto& section : known["sections"]) {
    const std::vector<double> state = lagged(clock, input, Hold::straight, section[1]);
    for (std::size_t k = 0; k < input.size(); ++k) sum[k] += section[0].get<double>() * state[k];
  }
  const std::vector<double> expected = numbers(known["y"]);
  for (std::size_t k = 0; k < input.size(); ++k) EXPECT_NEAR(sum[k], expected[k], 1e-9) << k;
}

/// Where the input is straight, twice as many samples change nothing.
TEST(Lag, DoesNotDependOnHowFinelyAStraightInputIsSampled) {
  std::vector<double> coarse_time, coarse, fine_time, fine;
  for (int k = 0; k <= 20; ++k) {
    coarse_time.push_back(60.0 * k);
    coarse.push_back(0.3 * k);
  }
  for (int k = 0; k <= 40; ++k) {
    fine_time.push_back(30.0 * k);
    fine.push_back(0.15 * k);
  }
  const auto a = lagged(clock_of(coarse_time), coarse, Hold::straight, 700.0);
  const auto b = lagged(clock_of(fine_time), fine, Hold::straight, 700.0);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[2 * k], 1e-12);
}

TEST(Lag, BeginsEveryRunAnew) {
  Clock clock = clock_of({0, 60, 120, 180, 240});
  clock.begins[3] = true;
  const auto state = lagged(clock, {1, 1, 1, 1, 1}, Hold::held, 100.0, 0.5);
  EXPECT_DOUBLE_EQ(state[3], 0.5);
  EXPECT_DOUBLE_EQ(state[4], state[1]);
}

/// What a control with single precision makes of two slow sections over 20 h.
TEST(Lag, AsIncrementsInSinglePrecisionStaysWithinAPerMille) {
  const auto known = reference("delta_form_float32");
  float fast = 0.0F, slow = 0.0F;
  const auto slow_rise = static_cast<float>(lag_step(1.0 / 5400, Hold::held).old_weight);
  const auto fast_rise = static_cast<float>(lag_step(1.0 / 900, Hold::held).old_weight);
  for (int k = 0; k < 72000; ++k) {
    slow += slow_rise * (7.0F - slow);
    fast += fast_rise * (3.0F - fast);
  }
  EXPECT_NEAR(slow + fast, known["y_um"].get<double>(), 1e-4);
  EXPECT_NEAR(slow + fast, 10.0, 0.01);
}

}  // namespace
}  // namespace raceway::correction
