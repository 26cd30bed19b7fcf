#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "results/beam_results.h"

namespace raceway::results {
namespace {

/// One forward mode of constant frequency, at two speeds.
std::vector<ModesAtSpeed> forward_mode(double frequency, double first, double second) {
  std::vector<ModesAtSpeed> speeds(2);
  speeds[0].speed = first;
  speeds[1].speed = second;
  for (ModesAtSpeed& at : speeds)
    at.modes.modes.push_back(
        {.frequency = frequency, .whirl = spindle::Whirl::forward, .y = {}, .z = {}});
  return speeds;
}

// 1x meets a frequency of 300 rad/s at 300 rad/s, wherever the range of speeds begins or ends.
TEST(Crossings, AreFoundAtTheEndsOfTheRange) {
  for (const auto& [first, second] : {std::pair{300.0, 400.0}, {200.0, 300.0}, {250.0, 350.0}}) {
    const std::vector<Crossing> found = crossings(forward_mode(300.0, first, second));
    ASSERT_EQ(found.size(), 1u) << first;
    EXPECT_EQ(found[0].excitation, "1x");
    EXPECT_DOUBLE_EQ(found[0].speed, 300.0);
    EXPECT_DOUBLE_EQ(found[0].frequency, 300.0);
  }
}

}  // namespace
}  // namespace raceway::results
