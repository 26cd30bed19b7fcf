#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "effects/catalogue.h"
#include "model/needs.h"
#include "tests/support/shafts.h"

namespace raceway::effects {
namespace {

/// What these effects make of a spindle as entered.
SpindleCondition with(std::vector<std::pair<std::string_view, std::vector<double>>> list) {
  std::vector<Effect> effects;
  for (auto& [id, values] : list)
    effects.push_back({.description = find(id, Form::spindle), .values = std::move(values)});
  return spindle_condition(effects);
}

std::vector<const Description*> of_spindles() {
  std::vector<const Description*> list;
  for (const Description& d : catalogue(Form::spindle))
    if (d.spindle) list.push_back(&d);
  return list;
}

TEST(SpindleEffects, AtTheirNeutralValueChangeNothingToTheLastDigit) {
  for (const Description* d : of_spindles()) {
    SCOPED_TRACE(std::string(d->id));
    SpindleCondition plain = with({{d->id, neutral_values(*d)}});
    // A time constant of nothing does nothing.
    if (plain.structure_rise == 0.0) plain.structure_time = SpindleCondition{}.structure_time;
    EXPECT_EQ(plain, SpindleCondition{});
  }
}

TEST(SpindleEffects, ChangeOneNumberEachAndInTheUnitOfTheirParameter) {
  const auto expect = [](std::string_view id, std::vector<double> values, auto set) {
    SpindleCondition wanted;
    set(wanted);
    EXPECT_EQ(with({{id, values}}), wanted) << id;
  };
  using C = SpindleCondition;
  expect("coolant", {25.0, 0.25}, [](C& c) { c.sleeve_conductance = 25.0, c.sleeve_reach = 0.25; });
  expect("seat-conductance", {0.15}, [](C& c) { c.outer_seat_factor = 0.15; });
  expect("motor-heat", {400.0}, [](C& c) { c.motor_heat = 400.0; });
  expect("drive-heat", {150.0}, [](C& c) { c.drive_heat = 150.0; });
  expect("convection-factor", {2.0}, [](C& c) { c.convection_factor = 2.0; });
  expect("bearing-conductance", {3.0}, [](C& c) { c.bearing_conductance_factor = 3.0; });
  expect("preload-growth", {0.7}, [](C& c) { c.other_preload_feedback = 0.7; });
  expect("structure-temperature", {-4.0, 0.5}, [](C& c) {
    c.structure_rise = -4.0;
    c.structure_time = 1800.0;
  });
  expect("flange-conductance", {0.3}, [](C& c) { c.flange_conductance_factor = 0.3; });
  expect("seal-heat", {30.0}, [](C& c) { c.seal_heat = 30.0; });
  expect("front-bearing-heat", {60.0}, [](C& c) { c.front_bearing_heat = 60.0; });
  expect("rear-bearing-heat", {90.0}, [](C& c) { c.rear_bearing_heat = 90.0; });
  std::set<std::string_view> ids;
  for (const Description* d : of_spindles()) ids.insert(d->id);
  EXPECT_EQ(ids.size(), 12u) << "one that this test does not know";
}

TEST(SpindleEffects, ActTogetherInAnyOrder) {
  const SpindleCondition both = with({{"seat-conductance", {0.5}}, {"drive-heat", {80.0}}});
  EXPECT_EQ(both.outer_seat_factor, 0.5);
  EXPECT_EQ(both.drive_heat, 80.0);
  EXPECT_EQ(with({{"drive-heat", {80.0}}, {"seat-conductance", {0.5}}}), both);
  // One that acts elsewhere leaves it alone.
  EXPECT_EQ(with({{"windage", {5.0}}}), SpindleCondition{});
}

TEST(SpindleEffects, KeepEveryPartOfASpindleWithinTheirBounds) {
  for (const Description* d : of_spindles())
    for (const double share : {0.0, 0.5, 1.0}) {
      std::vector<double> values;
      for (const Parameter& p : d->parameters)
        values.push_back(p.lower + share * (p.upper - p.lower));
      const SpindleCondition c = with({{d->id, values}});
      for (const double factor : {c.outer_seat_factor, c.convection_factor,
                                  c.bearing_conductance_factor, c.flange_conductance_factor})
        EXPECT_GE(factor, 0.02) << d->id;
      for (const double source : {c.motor_heat, c.drive_heat, c.seal_heat, c.front_bearing_heat,
                                  c.rear_bearing_heat, c.sleeve_conductance})
        EXPECT_GE(source, 0.0) << d->id;
      EXPECT_GT(c.structure_time, 0.0) << d->id;
    }
}

TEST(SpindleEffects, NeedATimeOfEveryRow) {
  for (const Description* d : of_spindles()) EXPECT_EQ(d->needs[0], Need::time) << d->id;
}

TEST(SpindleEffects, OfPreloadGrowthIsOfModelsWithFrictionOfTheColdSetsAlone) {
  model::Model spindle = fit::two_against_one();
  spindle.spindle.emplace();
  EXPECT_EQ(spindle.form(), Form::spindle);
  record::Record record;
  record.set(record::time, {0.0, 60.0});
  const Description& growth = *find("preload-growth", Form::spindle);
  spindle.spindle->preload_feedback = true;
  EXPECT_NE(model::missing_need(growth, spindle, record).find("preload_feedback = false"),
            std::string::npos);
  spindle.spindle->preload_feedback = false;
  EXPECT_EQ(model::missing_need(growth, spindle, record), "");
  EXPECT_NE(model::missing_need(*find("thermal-preload", Form::spindle), spindle, record)
                .find("temperatures"),
            std::string::npos);
  // On a shaft alone there is no such thing.
  EXPECT_NE(model::missing_need(*find("coolant", Form::shaft), fit::two_against_one(), record)
                .find("[housing]"),
            std::string::npos);
}

}  // namespace
}  // namespace raceway::effects
