#include "spindle/step_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "spindle/power_laws.h"
#include "tests/spindle/reference.h"

namespace raceway::spindle {
namespace {

using testing::HasSubstr;

struct Sampled {
  std::vector<double> time, displacement;
};

Sampled sum_of(std::initializer_list<Lag> lags, double every, double until) {
  Sampled s;
  for (int k = 0; k * every <= until; ++k) {
    s.time.push_back(k * every);
    s.displacement.push_back(0.0);
    for (const Lag& lag : lags) s.displacement.back() += displacement_at(lag, k * every);
  }
  return s;
}

std::string refusal_of_step(const std::vector<double>& time,
                            const std::vector<double>& displacement) {
  try {
    (void)fit_step(time, displacement);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

// The published laws sampled at nine digits; their numbers are given to 1e-5.
TEST(StepFit, GivesThePublishedStepResponsesBack) {
  for (const nlohmann::json& c : references("fe_import_")) {
    const nlohmann::json& in = c["inputs"];
    const nlohmann::json& out = c["outputs"];
    const double tolerance = c["tolerance_rel"];
    std::vector<double> time = numbers(in["time_min"]);
    for (double& t : time) t *= one_minute;
    std::vector<LagAt> points;
    for (std::size_t k = 0; k < in["loads_W"].size(); ++k) {
      std::vector<double> displacement = numbers(in["displacement_um"][k]);
      for (double& u : displacement) u *= um;
      const StepFit fit = fit_step(time, displacement);
      const double K = out["K_um"][k], T = out["T_min"][k];
      EXPECT_NEAR(fit.one.gain / um / K, 1.0, tolerance);
      EXPECT_NEAR(fit.one.time_constant / one_minute / T, 1.0, tolerance);
      EXPECT_LT(fit.rms, 1e-6 * um);  // rounding of nine digits
      EXPECT_FALSE(fit.two_needed);
      EXPECT_TRUE(fit.settled);
      points.push_back({in["loads_W"][k], fit.one.gain, fit.one.time_constant});
    }
    const PowerLaws laws = fit_power_laws(points);
    EXPECT_NEAR(laws.gain_line.slope / um / out["K_slope"].get<double>(), 1.0, tolerance);
    EXPECT_NEAR(laws.gain_line.offset / um / out["K_offset"].get<double>(), 1.0, tolerance);
    EXPECT_NEAR(laws.time_line.slope / one_minute / out["T_slope"].get<double>(), 1.0, tolerance);
    EXPECT_NEAR(laws.time_line.offset / one_minute / out["T_offset"].get<double>(), 1.0, tolerance);
    EXPECT_NEAR(laws.valid_to / out["valid_to_W"].get<double>(), 1.0, tolerance);
    EXPECT_EQ(laws.valid_from, 0.0);
  }
}

TEST(StepFit, FindsOneLagWhereverItLies) {
  for (const double T : {20.0, 300.0, 4000.0, 60000.0})
    for (const double K : {30 * um, -4 * um}) {
      const Sampled s = sum_of({{K, T}}, 120.0, 14400.0);
      const StepFit fit = fit_step(s.time, s.displacement);
      EXPECT_NEAR(fit.one.gain / K, 1.0, 1e-8) << T;
      EXPECT_NEAR(fit.one.time_constant / T, 1.0, 1e-8) << T;
      EXPECT_FALSE(fit.two_needed) << T;
      EXPECT_EQ(fit.settled, T < 7200.0);
    }
}

TEST(StepFit, FindsTwoLagsAndSaysThatOneDoesNotDo) {
  const Lag fast{12 * um, 300.0}, slow{20 * um, 4500.0};
  const Sampled s = sum_of({slow, fast}, 60.0, 14400.0);
  const StepFit fit = fit_step(s.time, s.displacement);
  EXPECT_TRUE(fit.two_needed);
  EXPECT_NEAR(fit.fast.gain / fast.gain, 1.0, 1e-6);
  EXPECT_NEAR(fit.fast.time_constant / fast.time_constant, 1.0, 1e-6);
  EXPECT_NEAR(fit.slow.gain / slow.gain, 1.0, 1e-6);
  EXPECT_NEAR(fit.slow.time_constant / slow.time_constant, 1.0, 1e-6);
  EXPECT_LT(fit.rms_of_two, 1e-9 * um);
}

TEST(StepFit, TakesAnOvershootAsTwoLagsOfOppositeSigns) {
  const Lag up{40 * um, 400.0}, down{-15 * um, 3000.0};
  const Sampled s = sum_of({up, down}, 60.0, 14400.0);
  const StepFit fit = fit_step(s.time, s.displacement);
  EXPECT_TRUE(fit.two_needed);
  EXPECT_NEAR(fit.fast.gain / up.gain, 1.0, 1e-6);
  EXPECT_NEAR(fit.slow.gain / down.gain, 1.0, 1e-6);
}

// No other answer near it, or far away, is better.
TEST(StepFit, LeavesTheLeastOfAllLags) {
  const Sampled s = sum_of({{12 * um, 300.0}, {20 * um, 4500.0}}, 120.0, 14400.0);
  const StepFit fit = fit_step(s.time, s.displacement);
  for (double T = 10.0; T < 1e5; T *= 1.02)
    for (double K = 20 * um; K < 40 * um; K += 0.5 * um) {
      double squares = 0.0;
      for (std::size_t k = 0; k < s.time.size(); ++k)
        squares += std::pow(displacement_at({K, T}, s.time[k]) - s.displacement[k], 2);
      EXPECT_GE(std::sqrt(squares / static_cast<double>(s.time.size())), fit.rms);
    }
}

TEST(StepFit, KnowsNoOrderOfRowsAndNoUnit) {
  const Sampled s = sum_of({{12 * um, 300.0}, {20 * um, 4500.0}}, 120.0, 14400.0);
  Sampled turned = s;
  std::reverse(turned.time.begin(), turned.time.end());
  std::reverse(turned.displacement.begin(), turned.displacement.end());
  for (double& u : turned.displacement) u *= 1000.0;
  const StepFit a = fit_step(s.time, s.displacement);
  const StepFit b = fit_step(turned.time, turned.displacement);
  EXPECT_NEAR(b.one.gain / a.one.gain, 1000.0, 1e-6);
  EXPECT_NEAR(b.one.time_constant / a.one.time_constant, 1.0, 1e-9);
}

TEST(StepFit, OfFewRowsFindsOneLagAlone) {
  const Sampled s = sum_of({{12 * um, 300.0}}, 120.0, 480.0);
  const StepFit fit = fit_step(s.time, s.displacement);
  EXPECT_NEAR(fit.one.time_constant, 300.0, 1e-5);
  EXPECT_TRUE(std::isnan(fit.slow.gain));
  EXPECT_FALSE(fit.two_needed);
}

TEST(StepFit, FindsHowLagsOfGivenGainsFall) {
  const std::vector<double> gains{38 * um, 28 * um};
  std::vector<double> time, left;
  for (double t = 0.0; t <= 14400.0; t += 120.0) {
    time.push_back(t);
    left.push_back(gains[0] * std::exp(-t / 700.0) + gains[1] * std::exp(-t / 5000.0));
  }
  const std::vector<double> found = fit_decay(time, left, gains);
  EXPECT_NEAR(found[0] / 700.0, 1.0, 1e-5);
  EXPECT_NEAR(found[1] / 5000.0, 1.0, 1e-5);
  std::vector<double> one = left;
  for (std::size_t k = 0; k < time.size(); ++k) one[k] = gains[0] * std::exp(-time[k] / 700.0);
  EXPECT_NEAR(fit_decay(time, one, std::vector<double>{gains[0]}).front() / 700.0, 1.0, 1e-6);
}

TEST(StepFit, SaysWhatItCannotTake) {
  EXPECT_THAT(refusal_of_step({0, 60}, {0, 1e-6}), HasSubstr("two or more times after 0 s"));
  EXPECT_THAT(refusal_of_step({-1, 60, 120}, {0, 1e-6, 1e-6}), HasSubstr("time = -1 s"));
  EXPECT_THAT(refusal_of_step({0, 60, 120}, {0, 0, 0}), HasSubstr("0 at all times"));
  EXPECT_THAT(refusal_of_step({0, 60, 120}, {0, unset, 0}), HasSubstr("at 60 s"));
}

}  // namespace
}  // namespace raceway::spindle
