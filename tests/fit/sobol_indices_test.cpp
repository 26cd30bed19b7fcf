#include "fit/sobol_indices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace raceway::fit {
namespace {

using Function = std::function<double(std::span<const double>)>;

std::vector<double> values_of(const SobolDesign& design, const Function& f) {
  std::vector<double> values(design.evaluations()), point(design.inputs());
  for (std::size_t e = 0; e < values.size(); ++e) {
    design.point(e, point);
    values[e] = f(point);
  }
  return values;
}

SobolIndices indices_of(const Function& f, std::size_t inputs, std::size_t samples,
                        std::uint64_t seed = 1) {
  const SobolDesign design(inputs, samples, seed);
  return sobol_indices(design, values_of(design, f), seed);
}

/// sin x1 + 7 sin² x2 + 0.1 x3⁴ sin x1 over -π to π.
double ishigami(std::span<const double> u) {
  const auto x = [&](std::size_t i) { return std::numbers::pi * (2.0 * u[i] - 1.0); };
  return std::sin(x(0)) + 7.0 * std::pow(std::sin(x(1)), 2) +
         0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

// Closed form [Ishigami1990], with a = 7, b = 0.1: V = a²/8 + b π⁴/5 + b² π⁸/18 + 1/2.
constexpr double ishigami_first[] = {0.31390519, 0.44241114, 0.0};
constexpr double ishigami_total[] = {0.55758886, 0.44241114, 0.24368366};

TEST(SobolIndices, OfIshigamisFunctionAreThoseOfItsClosedForm) {
  const SobolIndices found = indices_of(ishigami, 3, 16384);
  EXPECT_EQ(found.complete, 16384U);
  EXPECT_NEAR(found.mean, 3.5, 1e-3);
  EXPECT_NEAR(found.std * found.std, 13.844588, 0.02);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.inputs[i].first, ishigami_first[i], 3e-3) << i;
    EXPECT_NEAR(found.inputs[i].total, ishigami_total[i], 3e-3) << i;
  }
}

TEST(SobolIndices, OfSobolsFunctionAreThoseOfItsClosedForm) {
  // Product of (|4 x - 2| + a)/(1 + a): V_i = 1/(3 (1 + a_i)²).
  const std::vector<double> a{0.0, 1.0, 4.5, 9.0, 99.0, 99.0, 99.0, 99.0};
  const auto g = [&](std::span<const double> u) {
    double product = 1.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      product *= (std::fabs(4.0 * u[i] - 2.0) + a[i]) / (1.0 + a[i]);
    return product;
  };
  double all = 1.0;
  std::vector<double> alone;
  for (const double one : a) {
    alone.push_back(1.0 / (3.0 * (1.0 + one) * (1.0 + one)));
    all *= 1.0 + alone.back();
  }
  const SobolIndices found = indices_of(g, a.size(), 16384);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(found.inputs[i].first, alone[i] / (all - 1.0), 4e-3) << i;
    EXPECT_NEAR(found.inputs[i].total, alone[i] * all / (1.0 + alone[i]) / (all - 1.0), 4e-3) << i;
  }
}

TEST(SobolIndices, IntervalsHoldTheTruthAsOftenAsTheySay) {
  int first = 0, total = 0;
  constexpr int runs = 40;
  for (int seed = 1; seed <= runs; ++seed) {
    const SobolIndices found = indices_of(ishigami, 3, 512, static_cast<std::uint64_t>(seed));
    for (std::size_t i = 0; i < 3; ++i) {
      first += std::fabs(found.inputs[i].first - ishigami_first[i]) <= found.inputs[i].first_error;
      total += std::fabs(found.inputs[i].total - ishigami_total[i]) <= found.inputs[i].total_error;
    }
  }
  // 95 % of 120 are 114; three deviations of such a count below.
  EXPECT_GE(first, 107);
  EXPECT_GE(total, 107);
}

TEST(SobolDesign, FillsEveryColumnEvenly) {
  constexpr std::size_t inputs = 40, samples = 256;
  const SobolDesign design(inputs, samples, 7);
  std::vector<double> point(inputs);
  for (std::size_t set = 0; set < 2; ++set)
    for (std::size_t i = 0; i < inputs; ++i) {
      std::vector<int> hits(samples, 0);
      for (std::size_t k = 0; k < samples; ++k) {
        design.point(k * (inputs + 2) + set, point);
        ++hits.at(static_cast<std::size_t>(point[i] * samples));
      }
      for (const int count : hits) ASSERT_EQ(count, 1) << "set " << set << " input " << i;
    }
}

TEST(SobolDesign, ChangesOneColumnAtATimeAndFollowsItsSeed) {
  const SobolDesign one(3, 64, 1), same(3, 64, 1), other(3, 64, 2);
  std::vector<double> a(3), b(3), ab(3), again(3);
  bool differs = false;
  for (std::size_t k = 0; k < 64; ++k) {
    one.point(5 * k, a);
    one.point(5 * k + 1, b);
    for (std::size_t i = 0; i < 3; ++i) {
      one.point(5 * k + 2 + i, ab);
      for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(ab[j], i == j ? b[j] : a[j]);
    }
    same.point(5 * k, again);
    EXPECT_EQ(again, a);
    other.point(5 * k, again);
    differs = differs || again != a;
  }
  EXPECT_TRUE(differs);
}

TEST(SobolIndices, LeaveSamplesWithoutAValueOutAndCountThem) {
  const SobolDesign design(3, 1024, 1);
  std::vector<double> values = values_of(design, ishigami);
  values[5 * 10 + 3] = values[5 * 700] = unset;
  const SobolIndices found = sobol_indices(design, values, 1);
  EXPECT_EQ(found.complete, 1022U);
  EXPECT_NEAR(found.inputs[1].total, ishigami_total[1], 0.03);
}

TEST(SobolIndices, OfAConstantAreNone) {
  const SobolIndices found = indices_of([](auto) { return 0.3; }, 2, 64);
  EXPECT_TRUE(std::isnan(found.inputs[0].first));
  EXPECT_TRUE(std::isnan(found.inputs[1].total));
}

TEST(SobolDesign, RefusesWhatIsNoPowerOfTwo) {
  EXPECT_THROW(SobolDesign(3, 1000, 1), std::invalid_argument);
  EXPECT_THROW(SobolDesign(0, 1024, 1), std::invalid_argument);
  EXPECT_THROW(SobolDesign(3, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::fit
