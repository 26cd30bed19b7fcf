#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Keys, AreFoundByWordsOfTableNameAndMeaning) {
  const Result r = run("keys \"coolant turn\"");
  EXPECT_EQ(r.status, 0);
  EXPECT_EQ(r.err, "");
  EXPECT_THAT(r.out, HasSubstr("[coolant]\n  pitch_mm  0.1 to 10000 mm; required\n"));
  EXPECT_THAT(r.out, Not(HasSubstr("flow_l_min")));
  EXPECT_THAT(run("keys tilt").out, HasSubstr("  tilt  locked or free; default \"locked\"\n"));
  EXPECT_THAT(run("keys \"law contact K_rs\"").out,
              HasSubstr("[friction]\n  K_rs  0 to 1e-06; default 0\n      law contact: "));
}

TEST(Keys, HaveUnitRangeDefaultAndMeaningAsJson) {
  const auto keys = nlohmann::json::parse(run("keys --json").out)["keys"];
  EXPECT_GT(keys.size(), 250u);
  for (const auto& key : keys) {
    EXPECT_NE(key["meaning"], "") << key;
    EXPECT_EQ(key["from"].is_null(), key["to"].is_null()) << key;
  }
  EXPECT_EQ(keys[3]["key"], "ball_diameter_mm");
  EXPECT_EQ(keys[3]["kind"], "number");
  EXPECT_EQ(keys[3]["unit"], "mm");
  EXPECT_EQ(keys[3]["from"], 0.1);
  EXPECT_EQ(keys[3]["to"], 300);
}

TEST(Keys, WordsOfNoKeyAreAnError) {
  const Result r = run("keys no-such-key");
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(r.out, "");
  EXPECT_THAT(r.err, HasSubstr("no key has \"no-such-key\""));
}

}  // namespace
}  // namespace raceway::tests
