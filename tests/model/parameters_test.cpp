#include "model/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "tests/support/shafts.h"

namespace raceway::fit {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names(const Model& model) {
  std::vector<std::string> list;
  for (const Parameter& p : parameters(model)) list.push_back(p.name);
  return list;
}

Parameter find(const Model& model, const std::string& name) {
  for (const Parameter& p : parameters(model))
    if (p.name == name) return p;
  throw std::out_of_range(name);
}

/// A value within the bounds, not the one that the model has.
double another(const Parameter& p) {
  const double end = std::isfinite(p.upper) ? p.upper : p.start + 1.0;
  return p.start + 0.02 * (p.start < end ? end - p.start : p.lower - p.start);
}

Model rig_with_effects() {
  Model model = synthetic_model();
  for (const char* id : {"windage", "mixed-lubrication", "spin-friction"})
    model.effects.push_back(
        {.description = effects::find(id), .values = effects::initial_values(*effects::find(id))});
  model.effects.push_back(
      effects::make_effect({.id = "of-mine",
                            .title = {},
                            .torque_Nmm = "c * (speed_rpm/1000)^k",
                            .parameters = {{"c", "N mm", 2.0}, {"k", "1", 1.5}}}));
  return model;
}

TEST(Parameters, AreReadBackAsTheyAreWritten) {
  const Model shaft = with_effect(with_effect(two_against_one(), "thermal-preload", {0.02}),
                                  "spin-friction", {0.06});
  for (const Model& before : {rig_with_effects(), shaft}) {
    const std::vector<Parameter> all = parameters(before);
    EXPECT_GE(all.size(), 8U);
    for (const Parameter& p : all) {
      SCOPED_TRACE(p.name);
      EXPECT_EQ(p.value, p.start);
      EXPECT_EQ(get(before, p), p.start);
      Model after = before;
      const double value = another(p);
      ASSERT_NE(value, p.start);
      set(after, p, value);
      EXPECT_NEAR(get(after, p), value, 1e-14 * std::abs(value));
      // Whoever writes a file sets each address by itself.
      Model by_address = before;
      for (const std::string& address : p.addresses) {
        Parameter one = p;
        one.addresses = {address};
        set(by_address, one, value);
        EXPECT_EQ(get(by_address, one), get(after, p));
      }
      // Nothing else has moved, but what stands for the same number.
      for (const Parameter& other : all) {
        EXPECT_EQ(get(by_address, other), get(after, other));
        if (other.addresses.front() == p.addresses.front() ||
            p.addresses.back() == other.addresses.back())
          continue;
        EXPECT_EQ(get(after, other), other.start) << other.name;
      }
      // And back again, to where it came from.
      set(after, p, p.start);
      EXPECT_NEAR(get(after, p), p.start, 1e-14 * std::abs(p.start));
    }
  }
}

TEST(Parameters, HaveTheAddressesOfTheirFile) {
  const Model model = rig_with_effects();
  EXPECT_THAT(find(model, "f0").addresses, ElementsAre("friction.f0"));
  EXPECT_THAT(find(model, "spin-friction.friction_coefficient").addresses,
              ElementsAre("effect.2.friction_coefficient"));
  EXPECT_THAT(find(model, "of-mine.k").addresses, ElementsAre("effect.3.k"));
  const Model shaft = two_against_one();
  EXPECT_THAT(find(shaft, "preload_N").addresses, ElementsAre("arrangement.preload_N"));
  EXPECT_THAT(find(shaft, "contact_angle_deg").addresses, ElementsAre("bearing.contact_angle_deg"));
  EXPECT_THAT(find(shaft, "conformity").addresses,
              ElementsAre("bearing.inner_conformity", "bearing.outer_conformity"));
}

TEST(Parameters, OfAnAddressThatTheModelLacksAreRefused) {
  Model model = rig_with_effects();
  for (const char* address :
       {"friction.f9", "friction", "effect.4.c", "effect.x.c", "effect.0", "effect.0.c", "rig.load",
        "arrangement.preload_N", "bearing.ball_count", ""}) {
    Parameter p{.name = "one", .unit = "1", .addresses = {address}};
    EXPECT_THROW(set(model, p, 1.0), std::invalid_argument) << address;
  }
  EXPECT_THROW((void)get(model, {.name = "none", .unit = "1"}), std::invalid_argument);
}

TEST(Parameters, BringBoundsRangeAndScale) {
  const Model model = rig_with_effects();
  const Parameter f0 = find(model, "f0");
  EXPECT_EQ(f0.start, 1.5);
  EXPECT_LT(f0.lower, 1.5);
  EXPECT_GT(f0.upper, 1.5);
  EXPECT_EQ(f0.scale, std::max(1.5, f0.initial));
  EXPECT_TRUE(std::isnan(f0.neutral));
  const Parameter spin = find(model, "spin-friction.friction_coefficient");
  EXPECT_EQ(spin.neutral, 0.0);
  EXPECT_EQ(spin.plausible_upper, 0.12);
  EXPECT_TRUE(std::isnan(find(model, "of-mine.k").neutral));
}

TEST(Parameters, OfWhatTurnsWithTheRotorOfACoastDownHaveNoUsualSize) {
  Model model = rig_with_effects();
  EXPECT_LT(find(model, "windage.torque_at_10000_rpm_Nmm").plausible_upper, 1e4);
  model.rig.inertia = 0.85;
  const Parameter windage = find(model, "windage.torque_at_10000_rpm_Nmm");
  EXPECT_EQ(windage.plausible_upper, windage.upper);
}

TEST(Parameters, OfAShaftAreThoseThatTheModelHasOnce) {
  EXPECT_THAT(names(synthetic_model()), ElementsAre("f0", "z", "y"));
  EXPECT_THAT(names(two_against_one()),
              ElementsAre("f0", "z", "y", "preload_N", "inner_conformity", "outer_conformity",
                          "conformity", "contact_angle_deg"));
  Model two = two_against_one();  // another bearing at the rear
  bearing::ArrangementDesign design = two.shaft->arrangement.design();
  design.rear[0].bearing = std::make_shared<const bearing::Bearing>(two.bearing);
  two.shaft->arrangement = bearing::Arrangement(design);
  EXPECT_THAT(names(two), ElementsAre("f0", "z", "y", "preload_N"));
  EXPECT_THROW(set(two, find(two_against_one(), "contact_angle_deg"), 20.0), std::invalid_argument);
  design.preload = bearing::PreloadOffset{10 * um};
  two.shaft->arrangement = bearing::Arrangement(design);
  EXPECT_THAT(names(two), ElementsAre("f0", "z", "y"));
  EXPECT_THROW(set(two, find(two_against_one(), "preload_N"), 500.0), std::invalid_argument);
}

TEST(Parameters, ThatOneArrangementCannotTakeAreRefused) {
  Model model = two_against_one();
  EXPECT_THROW(set(model, find(model, "contact_angle_deg"), 95.0), std::invalid_argument);
  EXPECT_THROW(set(model, find(model, "preload_N"), -1.0), std::invalid_argument);
  EXPECT_EQ(get(model, find(two_against_one(), "preload_N")), 600.0);
}

TEST(DefaultFree, IsWhatTheLawOrTheMountingLeavesUncertain) {
  EXPECT_THAT(default_free(friction::FrictionLaw::palmgren), ElementsAre("f0", "z"));
  EXPECT_THAT(default_free(friction::FrictionLaw::skf), ElementsAre("mu_EHL", "K_rs"));
  EXPECT_THAT(default_free(two_against_one()), ElementsAre("preload_N"));
  Model gap = two_against_one();
  bearing::ArrangementDesign design = gap.shaft->arrangement.design();
  design.preload = bearing::PreloadOffset{10 * um};
  gap.shaft->arrangement = bearing::Arrangement(design);
  EXPECT_THAT(default_free(gap), ElementsAre("f0", "z"));
}

}  // namespace
}  // namespace raceway::fit
