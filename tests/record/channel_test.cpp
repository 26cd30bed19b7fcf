#include "record/channel.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace raceway::record {
namespace {

TEST(Channels, AreEachDescribedOnce) {
  std::set<std::string_view> names;
  for (const Channel& c : channels) {
    EXPECT_TRUE(names.insert(c.name).second) << c.name;
    EXPECT_FALSE(c.words.empty()) << c.name;
    if (c.role == Role::run) continue;
    EXPECT_TRUE(c.name.starts_with(c.variable)) << c.name;
    EXPECT_FALSE(c.key_unit().empty()) << c.name;
    EXPECT_LT(c.lower, c.upper) << c.name;
    EXPECT_GT(c.factor, 0.0) << c.name;
    EXPECT_EQ(&c, find_channel(c.name));
    // What may explain a reading has levels and can be named as a place.
    if (c.is_input()) {
      EXPECT_GT(c.step, 0.0) << c.name;
      EXPECT_FALSE(c.place.empty()) << c.name;
    }
    if (c.role == Role::deviation) {
      const Channel* const of = find_channel(c.of);
      ASSERT_NE(of, nullptr) << c.name;
      EXPECT_EQ(of->role, Role::measured);
      EXPECT_EQ(of->key_unit(), c.key_unit());
    }
  }
  EXPECT_EQ(find_channel("speed"), nullptr);
}

TEST(Channels, ConvertWithFactorAndOffset) {
  EXPECT_DOUBLE_EQ(temperature.to_SI(25.0), 298.15);
  EXPECT_DOUBLE_EQ(temperature.in_unit(298.15), 25.0);
  EXPECT_DOUBLE_EQ(friction_torque.to_SI(250.0), 0.25);
  EXPECT_DOUBLE_EQ(speed.in_unit(speed.to_SI(12000.0)), 12000.0);
  EXPECT_EQ(friction_torque.key_unit(), "Nmm");
  EXPECT_EQ(speed.key_unit(), "rpm");
}

}  // namespace
}  // namespace raceway::record
