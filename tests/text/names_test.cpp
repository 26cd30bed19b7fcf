#include "text/names.h"

#include <gtest/gtest.h>

#include <vector>

namespace raceway::text {
namespace {

const std::vector<std::string> spoken_keys{"ball_count", "ball_diameter_mm", "pitch_diameter_mm",
                                           "speed_rpm", "axial_load_N"};

TEST(Names, EditDistanceCountsSwapsAsOneChangeAndIgnoresCase) {
  EXPECT_EQ(edit_distance("ball_count", "ball_count"), 0u);
  EXPECT_EQ(edit_distance("ball_cuont", "ball_count"), 1u);
  EXPECT_EQ(edit_distance("Speed_RPM", "speed_rpm"), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(Names, NearestNameFindsMisspeltKeys) {
  EXPECT_EQ(nearest_name("ball_cuont", spoken_keys), "ball_count");
  EXPECT_EQ(nearest_name("pich_diameter_mm", spoken_keys), "pitch_diameter_mm");
}

TEST(Names, NearestNameFindsAForgottenUnitOrFirstWord) {
  EXPECT_EQ(nearest_name("speed", spoken_keys), "speed_rpm");
  EXPECT_EQ(nearest_name("load_N", spoken_keys), "axial_load_N");
}

TEST(Names, NamesThatAreFarFromAllHaveNoNearest) {
  EXPECT_FALSE(nearest_name("samples_in_median", spoken_keys));
  EXPECT_FALSE(nearest_name("", spoken_keys));
  EXPECT_EQ(suggestion("zzzzzz", spoken_keys), "");
  EXPECT_EQ(suggestion("ball_cont", spoken_keys), "; did you mean ball_count?");
}

TEST(Names, AreListedWithAWordBeforeTheLast) {
  EXPECT_EQ(listed(std::vector<std::string>{}), "");
  EXPECT_EQ(listed(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(listed(std::vector<std::string>{"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(listed(std::vector<std::string>{"a", "b"}, "or"), "a or b");
}

}  // namespace
}  // namespace raceway::text
