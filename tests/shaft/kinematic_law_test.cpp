#include "shaft/kinematic_law.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "shaft/fit_kinematic_law.h"

namespace raceway::shaft {
namespace {

using record::Bound;

constexpr double A = 1.28e-3, B = 0.697, C = 5.3e-4;  // [Brecher2021, eq. 10]
const KinematicLaw published{A, B, C, 0.0, 10000 * rpm};

/// Points every 250 rpm from standstill to 10 000 rpm.
std::vector<DisplacementPoint> sampled(const KinematicLaw& law) {
  std::vector<DisplacementPoint> curve;
  for (int n = 0; n <= 10000; n += 250)
    curve.push_back({n * rpm, kinematic_displacement_um(n, law.A, law.B, law.C) * um});
  return curve;
}

/// The same with normal scatter [m] at every row but standstill.
std::vector<DisplacementPoint> scattered(const KinematicLaw& law, double scatter,
                                         std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<DisplacementPoint> curve = sampled(law);
  for (DisplacementPoint& p : curve)
    if (p.speed > 0.0) p.displacement += scatter * normal(random);
  return curve;
}

double second_difference(double n) {
  const double h = 1e-3 * n;
  const auto u = [](double x) { return kinematic_displacement_um(x, A, B, C); };
  return (u(n + h) - 2.0 * u(n) + u(n - h)) / (h * h);
}

void expect_same(const KinematicLaw& a, const KinematicLaw& b, double tolerance) {
  EXPECT_NEAR(a.A / b.A, 1.0, tolerance);
  EXPECT_NEAR(a.B / b.B, 1.0, tolerance);
  EXPECT_NEAR(a.C / b.C, 1.0, tolerance);
}

std::string refusal(const std::vector<DisplacementPoint>& curve,
                    const KinematicLawBounds& bounds = {}) {
  try {
    (void)fit_kinematic_law(curve, bounds);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

// Digits computed elsewhere from the published numbers.
TEST(KinematicLaw, GivesThePublishedDisplacements) {
  EXPECT_NEAR(evaluate(published, 1000 * rpm).displacement / um, 0.07523795418968, 1e-13);
  EXPECT_NEAR(evaluate(published, 5000 * rpm).displacement / um, 4.207540273477, 1e-11);
  EXPECT_NEAR(evaluate(published, 10000 * rpm).displacement / um, 12.396337902456, 1e-11);
}

TEST(KinematicLaw, BendsAtTheInflectionsOfThePublishedNumbersAndNowhereElse) {
  std::vector<double> inflections;
  for (double n = 2.0; n < 30000.0; n *= 1.02) {
    double low = n, high = 1.02 * n;
    if ((second_difference(low) > 0.0) == (second_difference(high) > 0.0)) continue;
    for (int step = 0; step < 40; ++step) {
      const double middle = 0.5 * (low + high);
      ((second_difference(middle) > 0.0) == (second_difference(low) > 0.0) ? low : high) = middle;
    }
    inflections.push_back(low);
  }
  // Computed elsewhere with 30 digits: 111.2810, 5691.2662.
  EXPECT_THAT(inflections, testing::ElementsAre(testing::DoubleNear(111.281, 0.01),
                                                testing::DoubleNear(5691.266, 0.05)));
}

TEST(KinematicLaw, SlopeIsThatOfTheDisplacement) {
  for (const double n : {0.5, 1.0, 30.0, 111.0, 900.0, 5691.0, 9999.0}) {
    const double h = 1e-5 * n;
    const double difference = (evaluate(published, (n + h) * rpm).displacement -
                               evaluate(published, (n - h) * rpm).displacement) /
                              (2.0 * h * rpm);
    EXPECT_NEAR(evaluate(published, n * rpm).slope / difference, 1.0, 1e-8) << n;
  }
}

TEST(KinematicLaw, StartsAtZeroWithInfiniteSlopeAndEndsAsAStraightLine) {
  const KinematicDisplacement rest = evaluate(published, 0.0);
  EXPECT_EQ(rest.displacement, 0.0);
  EXPECT_EQ(rest.slope, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(rest.inside);
  EXPECT_EQ(evaluate({-A, B, C, 0.0, 1.0}, 0.0).slope, -std::numeric_limits<double>::infinity());
  EXPECT_NEAR(kinematic_displacement_um(1e5, A, B, C) / (A * 1e5), 1.0, 1e-12);
}

TEST(KinematicLaw, HoldsItsEndsOutsideItsRangeAndSaysSo) {
  const KinematicLaw law{A, B, C, 500 * rpm, 10000 * rpm};
  for (const auto& [outside, end] : {std::pair{499.0, 500.0}, {0.0, 500.0}, {10001.0, 10000.0}}) {
    const KinematicDisplacement held = evaluate(law, outside * rpm);
    EXPECT_FALSE(held.inside);
    EXPECT_EQ(held.displacement, evaluate(law, end * rpm).displacement);
    EXPECT_EQ(held.slope, 0.0);
    EXPECT_TRUE(evaluate(law, end * rpm).inside);
  }
  const KinematicDisplacement none = evaluate(law, std::nan(""));
  EXPECT_FALSE(none.inside);
  EXPECT_TRUE(std::isnan(none.displacement));
}

TEST(FitKinematicLaw, OfThePublishedLawReturnsItsNumbers) {
  const KinematicLawFit fit = fit_kinematic_law(sampled(published));
  ASSERT_TRUE(fit.converged());
  expect_same(fit.law, published, 1e-9);
  EXPECT_EQ(fit.verdict, KinematicLawVerdict::follows);
  EXPECT_EQ(fit.rows, 40);
  EXPECT_EQ(fit.law.lowest_speed, 0.0);
  EXPECT_EQ(fit.law.highest_speed, 10000 * rpm);
  EXPECT_LT(fit.max_abs, 1e-10 * um);
}

TEST(FitKinematicLaw, OfOtherSizesSpeedsAndSignsReturnsTheirNumbers) {
  for (const KinematicLaw& law : {KinematicLaw{-1.28e-3, B, C}, KinematicLaw{5e-6, 0.3, 2e-3},
                                  KinematicLaw{2.0, 0.9, 1e-4}, KinematicLaw{1e-3, 0.05, 1e-3}}) {
    const KinematicLawFit fit = fit_kinematic_law(sampled(law));
    ASSERT_TRUE(fit.converged());
    expect_same(fit.law, law, 1e-6);
  }
}

TEST(FitKinematicLaw, FindsTheSameOptimumFromAThousandNoisyStarts) {
  std::mt19937_64 random(20260);
  const auto curve = scattered(published, 0.023 * um, random);
  const KinematicLawFit best = fit_kinematic_law(curve);
  std::lognormal_distribution<double> factor(0.0, 0.7);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int k = 0; k < 1000; ++k) {
    KinematicLaw start = published;
    start.B = any(random);
    start.C *= factor(random);
    const KinematicLawFit from_start = refine_kinematic_law(curve, start);
    ASSERT_TRUE(from_start.converged());
    SCOPED_TRACE(testing::Message() << "from B " << start.B << ", C " << start.C);
    ASSERT_NO_FATAL_FAILURE(expect_same(from_start.law, best.law, 1e-6));
    ASSERT_FALSE(HasFailure());
  }
}

TEST(FitKinematicLaw, NoStartEndsBelowTheOptimumOfTheGrid) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  int lost = 0;  // descents that end elsewhere: what the grid is for
  for (int k = 0; k < 30; ++k) {
    const KinematicLaw law{1e-3, any(random), 1e-4 * std::pow(20.0, any(random))};
    const auto curve = scattered(law, 0.3 * um, random);
    const KinematicLawFit best = fit_kinematic_law(curve);
    for (int start = 0; start < 5; ++start) {
      const KinematicLawFit other =
          refine_kinematic_law(curve, {1.0, any(random), 1e-6 * std::pow(1e4, any(random))});
      EXPECT_GE(other.misfit, best.misfit * (1.0 - 1e-9));
      lost += other.misfit > 1.001 * best.misfit ? 1 : 0;
    }
  }
  EXPECT_GT(lost, 5);
}

TEST(FitKinematicLaw, StandardErrorsCoverTheTruthAsOftenAsTheySay) {
  std::mt19937_64 random(7);
  constexpr int curves = 50;
  std::array<int, 3> within{}, within_declared{};
  for (int k = 0; k < curves; ++k) {
    auto curve = scattered(published, 0.05 * um, random);
    const auto count = [](const KinematicLawFit& fit, std::array<int, 3>& counts) {
      const std::array truth{A, B, C};
      for (std::size_t p = 0; p < 3; ++p)
        counts[p] += std::abs(fit.parameters[p].value - truth[p]) <= fit.parameters[p].std;
    };
    count(fit_kinematic_law(curve), within);
    for (DisplacementPoint& p : curve) p.std = 0.05 * um;
    const KinematicLawFit declared = fit_kinematic_law(curve);
    EXPECT_TRUE(declared.weighted);
    count(declared, within_declared);
  }
  // 68 % of 50, with a standard deviation of 3.3; with std only a misfit above it widens.
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_NEAR(within[p], 0.683 * curves, 11);
    EXPECT_NEAR(within_declared[p], 0.71 * curves, 11);
  }
}

TEST(FitKinematicLaw, WeightsCount) {
  auto curve = sampled(published);
  for (DisplacementPoint& p : curve) p.std = 0.01 * um;
  curve[20].displacement += 1.0 * um;
  curve[20].std = 100.0 * um;
  expect_same(fit_kinematic_law(curve).law, published, 1e-5);
  curve[3].std = unset;  // one row without: equal weights, and the outlier pulls
  const KinematicLawFit equal = fit_kinematic_law(curve);
  EXPECT_FALSE(equal.weighted);
  EXPECT_GT(std::abs(equal.law.B / B - 1.0), 1e-3);
}

TEST(FitKinematicLaw, TellsScatterFromAShapeThatItCannotTake) {
  std::mt19937_64 random(3);
  EXPECT_EQ(fit_kinematic_law(scattered(published, 0.1 * um, random)).verdict,
            KinematicLawVerdict::scatter);
  auto stiff = sampled(published);  // rises with the square and turns into saturation
  for (DisplacementPoint& p : stiff) {
    const double x = p.speed / (10000 * rpm);
    p.displacement = 10.0 * um * x * x / (0.05 + x * x);
  }
  const KinematicLawFit fit = fit_kinematic_law(stiff);
  EXPECT_EQ(fit.verdict, KinematicLawVerdict::stiff);
  EXPECT_GT(fit.mae, kinematic_law_tolerance);
}

TEST(FitKinematicLaw, OfASmallCurveCountsTheShareOfItsSize) {
  auto small = sampled(published);  // 0.1 um in all: any fit is within 0.023 um
  for (DisplacementPoint& p : small) {
    const double x = p.speed / (10000 * rpm);
    p.displacement = 0.1 * um * x * x / (0.05 + x * x);
  }
  const KinematicLawFit fit = fit_kinematic_law(small);
  EXPECT_LT(fit.mae, kinematic_law_tolerance);
  EXPECT_EQ(fit.verdict, KinematicLawVerdict::stiff);
}

TEST(FitKinematicLaw, OfAStraightLineSaysThatCIsNotDetermined) {
  const KinematicLawFit fit = fit_kinematic_law(sampled({1e-3, 0.0, 1e-3}));
  EXPECT_NEAR(fit.law.A, 1e-3, 1e-9);
  EXPECT_EQ(fit.parameters[1].at_bound, Bound::lower);
  EXPECT_FALSE(fit.parameters[2].identifiable);
  EXPECT_TRUE(std::isnan(fit.parameters[2].std));
  EXPECT_TRUE(std::isfinite(fit.parameters[0].std));
  EXPECT_THAT(texts(fit.notes), testing::Contains("C is not determined by these rows"));
}

TEST(FitKinematicLaw, StaysWithinItsBounds) {
  const KinematicLawFit fit =
      fit_kinematic_law(sampled(published), {.upper_B = 0.5, .lower_C = 1e-4, .upper_C = 1e-3});
  EXPECT_EQ(fit.law.B, 0.5);
  EXPECT_EQ(fit.parameters[1].at_bound, Bound::upper);
  EXPECT_TRUE(std::isnan(fit.parameters[1].std));
  EXPECT_GE(fit.law.C, 1e-4);
  EXPECT_LE(fit.law.C, 1e-3);
}

TEST(FitKinematicLaw, IsValidFromItsLowestRowToItsHighest) {
  auto curve = sampled(published);
  curve.erase(curve.begin(), curve.begin() + 2);
  const KinematicLawFit fit = fit_kinematic_law(curve);
  EXPECT_DOUBLE_EQ(fit.law.lowest_speed, 500 * rpm);
  EXPECT_FALSE(evaluate(fit.law, 400 * rpm).inside);
}

TEST(FitKinematicLaw, TellsOfADisplacementAtStandstill) {
  auto curve = sampled(published);
  curve[0].displacement = 0.4 * um;
  EXPECT_THAT(
      texts(fit_kinematic_law(curve).notes),
      testing::ElementsAre(testing::StartsWith("the displacement at standstill is 0.4 um")));
}

TEST(FitKinematicLaw, RefusesWhatItCannotFit) {
  using testing::HasSubstr;
  const auto curve = sampled(published);
  EXPECT_THAT(refusal({}), HasSubstr("0 different speeds"));
  EXPECT_THAT(refusal({curve.begin(), curve.begin() + 4}), HasSubstr("3 different speeds"));
  EXPECT_THAT(refusal(std::vector<DisplacementPoint>(40, curve[5])),
              HasSubstr("1 different speed above zero"));
  auto zero = curve;
  for (DisplacementPoint& p : zero) p.displacement = 0.0;
  EXPECT_THAT(refusal(zero), HasSubstr("all displacements are 0"));
  const auto with = [&](double speed, double displacement, double std) {
    auto changed = curve;
    changed[7] = {speed, displacement, std};
    return refusal(changed);
  };
  EXPECT_THAT(with(-100 * rpm, um, unset), HasSubstr("must be finite and not negative"));
  EXPECT_THAT(with(100 * rpm, std::nan(""), unset), HasSubstr("displacement"));
  EXPECT_THAT(with(100 * rpm, um, 0.0), HasSubstr("std = 0 um: must be above 0 and finite"));
  EXPECT_THAT(refusal(curve, {.lower_B = 0.5, .upper_B = 0.4}), HasSubstr("bounds of B"));
  EXPECT_THAT(refusal(curve, {.upper_B = 1.2}), HasSubstr("bounds of B"));
  EXPECT_THAT(refusal(curve, {.lower_C = -1.0}), HasSubstr("bounds of C"));
}

}  // namespace
}  // namespace raceway::shaft
