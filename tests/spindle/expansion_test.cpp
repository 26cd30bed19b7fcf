#include "spindle/expansion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/spindle/beam_cases.h"

namespace raceway::spindle {
namespace {

TEST(Expansion, SubstituteForcesGiveTheFreeElongation) {
  for (const nlohmann::json& c : references("substitute_force")) {
    const nlohmann::json& in = c.at("inputs");
    const double first = in.at("T_ends_K").at(0), last = in.at("T_ends_K").at(1);
    for (const int pieces : {1, 3, 20}) {
      std::vector<HeatedLength> bar;
      for (int i = 0; i < pieces; ++i)
        bar.push_back({.length = in.at("L_m").get<double>() / pieces,
                       .area = in.at("area_m2"),
                       .elastic_modulus = in.at("E_Pa"),
                       .thermal_expansion = in.at("alpha"),
                       .rise = first + (last - first) * (i + 0.5) / pieces});
      std::vector<double> nodes(bar.size() + 1);
      displace_by_substitute_forces(bar, nodes);
      const double free = c.at("outputs").at("free_elongation_um").get<double>() * um;
      const double held = c.at("outputs").at("force_if_clamped_N");
      const double tolerance = c.at("tolerance_rel");
      EXPECT_NEAR(nodes.back(), free, tolerance * std::abs(free));
      EXPECT_NEAR(free_elongation(bar), free, tolerance * std::abs(free));
      EXPECT_NEAR(std::abs(force_if_held(bar)), held, tolerance * held);
      EXPECT_EQ(force_if_held(bar) < 0.0, first + last > 0.0);
    }
  }
}

TEST(Expansion, OfSteppedBarsOfTwoMaterialsBothWaysAreEqual) {
  const std::vector<HeatedLength> bar{{.length = 0.05,
                                       .area = 7e-3,
                                       .elastic_modulus = 210e9,
                                       .thermal_expansion = 11.5e-6,
                                       .rise = 12},
                                      {.length = 0.18,
                                       .area = 4e-3,
                                       .elastic_modulus = 120e9,
                                       .thermal_expansion = 10.5e-6,
                                       .rise = -3},
                                      {.length = 0.02,
                                       .area = 2e-3,
                                       .elastic_modulus = 70e9,
                                       .thermal_expansion = 23e-6,
                                       .rise = 30}};
  std::vector<double> nodes(4);
  displace_by_substitute_forces(bar, nodes);
  EXPECT_NEAR(nodes.back(), free_elongation(bar), 1e-14 * 1e-3);
  EXPECT_NEAR(nodes[1], 0.05 * 11.5e-6 * 12, 1e-17);
}

TEST(Expansion, HeatedBarGrowsByTheIntegralOfItsRise) {
  const nlohmann::json c = test::beam_case("bar_heat"), &in = c.at("inputs");
  // Both ends at the ambient temperature: ΔT = q x (L - x)/(2 λ).
  const double length = in.at("L_m"), heat = in.at("q_W_m3"), conductivity = in.at("lam");
  constexpr int pieces = 60;
  std::vector<HeatedLength> bar;
  for (int i = 0; i < pieces; ++i) {
    const double x = length * (i + 0.5) / pieces;
    bar.push_back({.length = length / pieces,
                   .area = 1e-3,
                   .elastic_modulus = 210e9,
                   .thermal_expansion = in.at("alpha"),
                   .rise = heat * x * (length - x) / (2.0 * conductivity)});
  }
  std::vector<double> nodes(bar.size() + 1);
  displace_by_substitute_forces(bar, nodes);
  const double expected = c.at("outputs").at("elongation_um").get<double>() * um;
  EXPECT_NEAR(nodes.back(), expected, c.at("tolerance_rel").get<double>() * expected);
  EXPECT_NEAR(nodes.back(), free_elongation(bar), 1e-12 * expected);
}

}  // namespace
}  // namespace raceway::spindle
