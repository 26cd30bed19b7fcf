#include "correction/transfer_function.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/correction/reference.h"

namespace raceway::correction {
namespace {

/// The transfer functions that were published, as printed. Their coefficients are in um/K, here
/// too: all of it is linear in the numerator.
class Published : public testing::TestWithParam<const char*> {
 protected:
  nlohmann::json known = reference(GetParam());
  TransferFunction f{.numerator = numbers(known["a"]),
                     .denominator = numbers(known["b"]),
                     .sampling = known["sampling_s"]};
};

TEST_P(Published, HasItsPoles) {
  const TransferFunctionCheck c = check(f);
  ASSERT_EQ(c.poles.size(), known["poles"].size());
  for (const auto& pole : known["poles"])
    EXPECT_THAT(c.poles, testing::Contains(testing::ResultOf(
                             [&](const std::complex<double>& p) {
                               return std::abs(p - std::complex<double>(pole[0], pole[1]));
                             },
                             testing::Lt(1e-7))));
  for (const auto& constant : known["time_constants_s"]) {
    if (constant.is_null()) continue;
    const double expected = constant;
    // A pole known to 1e-7 leaves this of a time constant.
    const double leeway = 1e-7 * expected * expected + 1e-6;
    EXPECT_THAT(c.time_constants, testing::Contains(testing::DoubleNear(expected, leeway)));
  }
  const auto none = std::count_if(c.time_constants.begin(), c.time_constants.end(),
                                  [](double t) { return std::isnan(t); });
  EXPECT_EQ(none, std::count(known["time_constants_s"].begin(), known["time_constants_s"].end(),
                             nullptr));
}

TEST_P(Published, HasItsGainAndWhatRoundingLeavesOpen) {
  const TransferFunctionCheck c = check(f);
  EXPECT_NEAR(c.dc_gain / known["dc_gain_um_K"].get<double>(), 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(c.feedthrough, known["feedthrough_um_K"].get<double>());
  EXPECT_NEAR(c.unstable_share, known["unstable_share_if_rounded"].get<double>(), 0.03);
  const double lower = known["dc_if_rounded_5_95"][0], upper = known["dc_if_rounded_5_95"][1];
  EXPECT_NEAR(c.dc_gain_lower, lower, 0.2 * (upper - lower));
  EXPECT_NEAR(c.dc_gain_upper, upper, 0.2 * (upper - lower));
}

TEST_P(Published, AnswersAStepAsTheReference) {
  const auto& response = known["step_response"];
  const auto samples = response["time_s"].get<std::vector<std::size_t>>();
  const std::vector<double> step(samples.back() + 1, 1.0);
  const std::vector<double> y = run(f, step);
  for (std::size_t k = 0; k < samples.size(); ++k)
    EXPECT_NEAR(y[samples[k]] / response["um"][k].get<double>(), 1.0, 1e-6) << samples[k];
  const auto peak = std::max_element(y.begin(), y.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
  EXPECT_NEAR(*peak / known["step_peak_um"].get<double>(), 1.0, 1e-6);
  // At its end an answer is flat to the last digits: many times are that of the peak.
  const auto of_peak = std::min(known["step_peak_time_s"].get<std::size_t>(), y.size() - 1);
  EXPECT_NEAR(y[of_peak] / known["step_peak_um"].get<double>(), 1.0, 1e-6);
}

TEST_P(Published, EndsInSinglePrecisionWhereTheReferenceDoes) {
  const std::vector<float> step(144000, 1.0F);
  EXPECT_NEAR(run_single(f, step).back() / known["float32_direct_form_40h_um"].get<double>(), 1.0,
              0.05);
}

TEST_P(Published, WarnsOfWhatTheReferenceWarnsOf) {
  TransferFunction in_metres = f;
  for (double& a : in_metres.numerator) a *= um;
  const auto said = check(in_metres).warnings;
  const auto expected = known["warnings"].get<std::vector<std::string>>();
  for (const char* start :
       {"negative real pole", "pole on or outside the unit circle",
        "rounding of the printed digits", "DC gain not determined", "feedthrough turns a"}) {
    const auto begins = [&](const std::string& w) { return w.rfind(start, 0) == 0; };
    EXPECT_EQ(std::any_of(said.begin(), said.end(), begins),
              std::any_of(expected.begin(), expected.end(), begins))
        << start;
  }
}

/// The answer of a parallel form at every sample.
std::vector<double> answer_of(const ParallelForm& form, const std::vector<double>& input) {
  std::vector<double> state(form.lags.size(), 0.0), output;
  for (std::size_t k = 0; k < input.size(); ++k) {
    double y = form.through * input[k];
    for (std::size_t i = 0; i < state.size(); ++i) {
      const ParallelForm::Lag& lag = form.lags[i];
      if (k > 0) state[i] += lag.rise * (lag.gain * input[k - 1] - state[i]);
      y += state[i];
    }
    output.push_back(y);
  }
  return output;
}

std::vector<double> wavy_input(std::size_t samples) {
  std::vector<double> input;
  for (std::size_t k = 0; k < samples; ++k) {
    const double t = static_cast<double>(k);
    input.push_back(8.0 * std::sin(t / 700.0) + (k / 1500 % 2 == 0 ? 1.0 : 0.0));
  }
  return input;
}

double largest_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

TEST_P(Published, IsTheSumOfItsLagsOrIsRefused) {
  bool lags = true;
  for (const auto& p : check(reduced(f)).poles)
    lags = lags && p.imag() == 0.0 && p.real() > 0.0 && p.real() < 1.0;
  if (!lags) {
    EXPECT_THROW((void)parallel_form(f), std::invalid_argument);
    return;
  }
  const ParallelForm form = parallel_form(f);
  const std::vector<double> input = wavy_input(20000), y = run(f, input);
  double size = 0.0;
  for (const double v : y) size = std::max(size, std::abs(v));
  // The direct form itself loses digits: those of its poles' distance from 1.
  EXPECT_LT(largest_distance(answer_of(form, input), y), 1e-6 * size);
}

INSTANTIATE_TEST_SUITE_P(TransferFunction, Published,
                         testing::Values("tf_S2_SP1", "tf_S2_amb", "tf_S2_SP2", "tf_S3_Z_amb",
                                         "tf_S3_Z_X", "tf_S3_Z_Y", "tf_S3_Z_Z"),
                         [](const auto& of) { return std::string(of.param); });

/// Why models are kept in sections: printed with four decimals, this one has another gain.
TEST(TransferFunction, OfSlowSectionsHangsOnDigitsThatNobodyPrints) {
  const auto known = reference("why_not_polynomials");
  const auto b = numbers(known["denominator"]);
  EXPECT_NEAR(std::accumulate(b.begin(), b.end(), 0.0) / known["sum_b"].get<double>(), 1.0, 1e-4);
  const double p = std::exp(-1.0 / 5400), q = std::exp(-1.0 / 900);
  EXPECT_NEAR(b[1], -(p + q), 1e-10);
  EXPECT_NEAR(b[2], p * q, 1e-12);
  TransferFunction rounded{.numerator = {1e-7}, .denominator = {1, -1.9987, 0.9987}, .sampling = 1};
  EXPECT_THAT(check(rounded).warnings, testing::Contains(testing::HasSubstr("unit circle")));
}

TEST(TransferFunction, RefusesWhatItCannotRun) {
  const auto refused = [](TransferFunction f, const char* why) {
    try {
      static_cast<void>(reduced(f));
      ADD_FAILURE() << why;
    } catch (const std::invalid_argument& e) {
      EXPECT_THAT(e.what(), testing::HasSubstr(why));
    }
  };
  refused({{}, {1.0}, 1.0}, "needs a numerator");
  refused({{1.0}, {2.0, 1.0}, 1.0}, "must begin with 1");
  refused({{1.0}, {1.0, -0.9}, 0.0}, "sampling interval");
  refused({{unset}, {1.0, -0.9}, 1.0}, "not finite");
}

// Lags of bodies, multiplied out: they come back.
TEST(ParallelForm, FindsTheLagsThatMadeThePolynomials) {
  const double p1 = std::exp(-10.0 / 5400), p2 = std::exp(-10.0 / 900), through = 0.4;
  const double g1 = (1 - p1) * 5.0, g2 = (1 - p2) * -3.0;
  // through + g1 x/(1 - p1 x) + g2 x/(1 - p2 x)
  const TransferFunction f{
      .numerator = {through, -through * (p1 + p2) + g1 + g2, through * p1 * p2 - g1 * p2 - g2 * p1},
      .denominator = {1.0, -(p1 + p2), p1 * p2},
      .sampling = 10.0};
  const ParallelForm form = parallel_form(f);
  ASSERT_EQ(form.lags.size(), 2u);
  EXPECT_DOUBLE_EQ(form.through, through);
  EXPECT_NEAR(-10.0 / std::log1p(-form.lags[0].rise), 5400, 1e-5);  // digits of the coefficients
  EXPECT_NEAR(-10.0 / std::log1p(-form.lags[1].rise), 900, 1e-6);
  EXPECT_NEAR(form.lags[0].gain, 5.0, 1e-8);
  EXPECT_NEAR(form.lags[1].gain, -3.0, 1e-8);
}

TEST(ParallelForm, RefusesWhatIsNoSumOfLags) {
  const auto refusal = [](std::vector<double> a, std::vector<double> b) {
    try {
      (void)parallel_form({std::move(a), std::move(b), 1.0});
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal({1.0}, {1, -1.2, 0.72}), testing::HasSubstr("are complex"));
  EXPECT_THAT(refusal({1.0}, {1, 0.5}), testing::HasSubstr("the pole -0.5 is not between"));
  EXPECT_THAT(refusal({1.0}, {1, -1.0}), testing::HasSubstr("the pole 1 is not between"));
  EXPECT_THAT(refusal({1.0, 0.0, 2.0}, {1, -0.5}),
              testing::HasSubstr("more coefficients than the denominator"));
  EXPECT_THAT(refusal({1.0}, {1, -1.0, 0.25}), testing::HasSubstr("occurs twice"));
  EXPECT_EQ(parallel_form({{2.0}, {1.0}, 1.0}).lags.size(), 0u);
}

}  // namespace
}  // namespace raceway::correction
