#include "model/needs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "effects/formula.h"
#include "tests/support/shafts.h"

namespace raceway::fit {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string missing(const char* id, const Model& model, const DataSet& data) {
  return missing_need(*effects::find(id, model.form()), model, data);
}

std::string levels(const char* id, const Model& model, const DataSet& data) {
  return missing_levels(*effects::find(id, model.form()), model, data);
}

TEST(Needs, AreTheTimeAndTheRingTemperaturesOfEveryRow) {
  DataSet data = factorial_plan({1000, 2000}, {100, 200}, {40});
  const Model model = with_effect(synthetic_model(), "spin-friction", {0.06});
  EXPECT_THAT(missing("torque-time-drift", model, data), HasSubstr("time_s of every row"));
  EXPECT_THAT(missing("thermal-ring-growth", model, data), HasSubstr("inner_ring_temperature_C"));
  for (Row& row : data.rows) row.time = row.inner_ring_temperature = row.outer_ring_temperature = 1;
  EXPECT_THAT(missing("torque-time-drift", model, data), IsEmpty());
  EXPECT_THAT(missing("thermal-ring-growth", model, data), IsEmpty());
  data.rows[2].time = data.rows[1].outer_ring_temperature = unset;
  EXPECT_THAT(missing("torque-time-drift", model, data), HasSubstr("time_s"));
  EXPECT_THAT(missing("thermal-ring-growth", model, data), HasSubstr("outer_ring_temperature_C"));
}

TEST(Needs, AnotherSupplyRulesOut) {
  Model model = synthetic_model();
  const auto why = [&](const char* id) { return ruled_out(*effects::find(id), model); };
  EXPECT_THAT(why("churning"), IsEmpty());
  model.supply = friction::Supply::oil_air;
  EXPECT_EQ(why("churning"),
            "the bearing is lubricated by oil-air, but this effect needs an oil bath");
  EXPECT_EQ(
      why("lubricant-drag"),
      "the bearing is lubricated by oil-air, but this effect needs an oil jet or an oil bath");
  EXPECT_THAT(why("replenishment-starvation"), IsEmpty());
  EXPECT_THAT(why("windage"), IsEmpty());
  model.supply = friction::Supply::bath;
  EXPECT_THAT(why("churning"), IsEmpty());
  EXPECT_EQ(why("replenishment-starvation"),
            "the bearing is lubricated by an oil bath, but this effect needs oil-air, grease or an "
            "oil jet");
  EXPECT_EQ(why("grease-churning"),
            "the bearing is lubricated by an oil bath, but this effect needs grease");
}

TEST(Needs, AreALoadOnEveryRowWhateverItsDirection) {
  DataSet data = factorial_plan({1000, 2000}, {0, 200}, {40});
  EXPECT_THAT(missing("spin-friction", synthetic_model(), data), HasSubstr("a load in every row"));
  data.rows[0].point.radial_load = 50.0;
  data.rows[1].point.radial_load = 50.0;
  EXPECT_THAT(missing("spin-friction", synthetic_model(), data), IsEmpty());
}

TEST(Needs, AreLevelsFarEnoughApart) {
  const Model model = synthetic_model();
  EXPECT_THAT(levels("spin-friction", model, factorial_plan({1000, 2000}, {200}, {40})),
              HasSubstr("more than one load"));
  EXPECT_THAT(levels("spin-friction", model, factorial_plan({1000, 2000}, {200, 201}, {40})),
              HasSubstr("more than one load"));
  EXPECT_THAT(levels("spin-friction", model, factorial_plan({1000, 2000}, {200, 300}, {40})),
              IsEmpty());
  EXPECT_THAT(levels("windage", model, factorial_plan({1000, 1005}, {200}, {40})),
              HasSubstr("more than one speed"));
}

TEST(Needs, OfAFormulaAreTheChannelsThatItUses) {
  const effects::Effect mine = effects::make_effect({.id = "mine",
                                                     .title = {},
                                                     .torque_Nmm = "c * preload_N",
                                                     .parameters = {{"c", "N mm", 0.0}}});
  DataSet data = factorial_plan({1000, 2000}, {200}, {40});
  EXPECT_THAT(missing_need(*mine.description, synthetic_model(), data),
              HasSubstr("preload_N of every row"));
  for (Row& row : data.rows) row.preload = 300.0;
  EXPECT_THAT(missing_need(*mine.description, synthetic_model(), data), IsEmpty());
}

TEST(Needs, OfWhatActsOnTheOtherMeasurementAreThatOne) {
  DataSet data = factorial_plan({1000, 2000}, {200}, {40});
  EXPECT_THAT(missing("shaft-contraction", synthetic_model(), data),
              HasSubstr("axial displacement of a shaft"));
  EXPECT_THAT(missing("shaft-contraction", two_against_one(), data),
              HasSubstr("axial displacement of a shaft"));
  EXPECT_THAT(missing("seal-friction", two_against_one(), data), IsEmpty());
  data.quantity = Quantity::axial_displacement;
  EXPECT_THAT(missing("seal-friction", two_against_one(), data), HasSubstr("friction torque"));
}

}  // namespace
}  // namespace raceway::fit
