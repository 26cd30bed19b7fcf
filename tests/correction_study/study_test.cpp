#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/correction_study/bars.h"
#include "tests/correction_study/judge.h"
#include "tests/correction_study/rig.h"

namespace correction_study {
namespace {

/// Two machines of each of some classes, of another draw than rules were chosen by.
std::vector<Outcome> small_study() {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "small_study";
  std::vector<Case> cases;
  for (const char* const id :
       {"nothing-missing", "ambient-drift", "sensor-quantisation", "door", "stray-readings"})
    for (const unsigned seed : {900U, 901U}) {
      const Rig rig = make_rig(find_class(id), seed);
      write_rig(rig, folder);
      cases.push_back(read_case(folder / rig.truth.id).value());
    }
  std::vector<Outcome> outcomes = judge_all(cases, 2, [](const Outcome&) {});
  std::filesystem::remove_all(folder);
  return outcomes;
}

TEST(SmallStudy, IsRight) {
  for (const Outcome& o : small_study()) {
    EXPECT_TRUE(o.right()) << line(o);
    EXPECT_FALSE(o.wrong()) << line(o);
    if (o.of.is_clean()) EXPECT_LE(o.base_test, o.of.tolerance) << line(o);
    if (!o.asked_again) continue;
    EXPECT_TRUE(o.content) << line(o);
    EXPECT_LE(o.added_test, 1.5 * o.of.floor) << line(o);
  }
}

}  // namespace
}  // namespace correction_study
