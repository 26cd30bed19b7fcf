#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "model/prediction.h"
#include "tests/reference_table.h"

namespace raceway {
namespace {

model::Model known_model(bool bore_70) {
  bearing::BearingGeometry g{.ball_count = 20,
                             .ball_diameter = 11.906 * mm,
                             .pitch_diameter = 90 * mm,
                             .contact_angle = 25 * degree,
                             .inner_conformity = 0.52,
                             .outer_conformity = 0.52,
                             .static_load_rating = 43000};
  if (!bore_70) {
    g.ball_diameter = 8.731 * mm;
    g.pitch_diameter = 65 * mm;
    g.contact_angle = 15 * degree;
    g.inner_conformity = g.outer_conformity = 0.523;
    g.static_load_rating = 24000;
  }
  return {.name = bore_70 ? "7014" : "7010",
          .bearing = bearing::Bearing(g, bearing::steel(), bearing::steel()),
          .lubricant = friction::Lubricant(32 * mm2_per_s, 5.9 * mm2_per_s),
          .law = friction::FrictionLaw::palmgren,
          .f1_load = friction::F1Load::F_b,  // the form of the program that made the rigs
          .law_values = {1.5, 0.001, 0.33},
          .effects = {},
          .solver = {},
          .rig = {},
          .free = {}};
}

/// Torque that a program of its own computed for an effect of known size, in data/hidden-effect.
/// The files print the torque to 1e-4 N mm and the temperature to 0.01 K.
void expect_torque_of(const std::string& file, model::Model model,
                      const std::vector<std::pair<const char*, std::vector<double>>>& hidden) {
  for (const auto& [id, values] : hidden) {
    ASSERT_NE(effects::find(id), nullptr);
    model.effects.push_back({effects::find(id), values, nullptr});
  }
  const auto rows = tests::reference_table("../hidden-effect/" + file);
  ASSERT_EQ(rows.size(), 120U);
  for (const tests::ReferenceRow& row : rows) {
    SCOPED_TRACE(row.place());
    bearing::OperatingPoint point{.speed = row["speed_rpm"] * rpm,
                                  .axial_load = row["axial_load_N"]};
    const auto torque = [&](double temperature) {
      point.temperature = kelvin(temperature);
      return model::predict_friction(model, point).reading / N_mm;
    };
    const double T = row["temperature_C"], truth = row["torque_Nmm"];
    const double warm = torque(T + 0.005), cold = torque(T - 0.005);
    EXPECT_GE(truth, std::min(warm, cold) - 1e-4);
    EXPECT_LE(truth, std::max(warm, cold) + 1e-4);
    EXPECT_NEAR(warm, cold, 4e-4 * truth);  // so that this says something
  }
}

TEST(KnownRigs, BaseLaw) {
  expect_torque_of("dev-01.csv", known_model(true), {});
  expect_torque_of("dev-08.csv", known_model(false), {});
}

TEST(KnownRigs, SpinFriction) {
  expect_torque_of("dev-02.csv", known_model(true), {{"spin-friction", {0.06209802612512208}}});
}

TEST(KnownRigs, LubricantDrag) {
  expect_torque_of("dev-03.csv", known_model(true), {{"lubricant-drag", {62.513631026171886}}});
}

TEST(KnownRigs, InletShearHeating) {
  expect_torque_of("dev-04.csv", known_model(false),
                   {{"inlet-shear-heating", {0.4357772785395507}}});
}

TEST(KnownRigs, ThermalPreload) {
  expect_torque_of("dev-05.csv", known_model(true), {{"thermal-preload", {1.7371207825820307}}});
}

TEST(KnownRigs, SealFrictionAndLubricantDrag) {
  expect_torque_of(
      "dev-06.csv", known_model(false),
      {{"seal-friction", {16.291367990148437, 0.0075}}, {"lubricant-drag", {25.636512814890615}}});
}

}  // namespace
}  // namespace raceway
