#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"

namespace raceway::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// A rig with a known hidden effect: drag of 62.5 N mm at 10 000 rpm.
const std::string rig = std::string(RACEWAY_SOURCE_DIR) + "/tests/hidden_effect/rigs/dev-03/";

TEST(Loop, NamesTheMissingEffectAndAddsIt) {
  const ScratchFolder scratch;
  const Result found = run("diagnose " + rig + "model.toml " + rig + "train.csv --json");
  ASSERT_EQ(found.status, 0) << found.err;
  const json d = json::parse(found.out);
  EXPECT_EQ(d["verdict"], "effect");
  EXPECT_EQ(d["effects"][0]["id"], "lubricant-drag");
  EXPECT_TRUE(d["effects"][0]["in_verdict"]);
  for (const char* key : {"sentence", "baseline", "effects", "would_have_been_found",
                          "not_testable", "suggested_measurements"})
    EXPECT_TRUE(d.contains(key)) << key;

  const std::string better = scratch.file("better.toml");
  const Result added =
      run("add " + rig + "model.toml lubricant-drag --data " + rig + "train.csv -o " + better);
  ASSERT_EQ(added.status, 0) << added.err;
  const std::string before = file_text(rig + "model.toml"), after = file_text(better);
  EXPECT_THAT(after, StartsWith(before.substr(0, before.find('\n'))));
  EXPECT_THAT(after, HasSubstr("id = \"lubricant-drag\""));

  const Result ladder =
      run("compare " + rig + "model.toml " + better + " " + rig + "test.csv --json");
  ASSERT_EQ(ladder.status, 0) << ladder.err;
  const json models = json::parse(ladder.out)["models"];
  EXPECT_LT(models[1]["rmse"].get<double>(), 0.25 * models[0]["rmse"].get<double>());
}

TEST(Loop, AnswersAnUnknownEffectWithTheNearestAndWritesNothing) {
  const ScratchFolder scratch;
  const Result r = run("add " + rig + "model.toml lubricant-drug --data " + rig + "train.csv -o " +
                       scratch.file("x.toml"));
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("lubricant-drag"));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("x.toml")));
}

TEST(Loop, ExplainsEveryEffectOfTheCatalogue) {
  const Result all = run("effects --json");
  ASSERT_EQ(all.status, 0) << all.err;
  const json list = json::parse(all.out)["effects"];
  EXPECT_GE(list.size(), 29U);
  const Result one = run("effects spin-friction");
  EXPECT_EQ(one.status, 0);
  EXPECT_THAT(one.out, HasSubstr("friction_coefficient"));
  const Result unknown = run("effects spin-frictoin");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr("spin-friction"));
}

TEST(Loop, ShowsWhereAFormulaIsWrong) {
  const ScratchFolder scratch;
  const std::string model =
      scratch.write("m.toml", file_text(rig + "model.toml") +
                                  "\n[[effect]]\nid = \"mine\"\ntorque_Nmm = \"c * sped_rpm\"\n"
                                  "c = { value = 0.0, unit = \"N mm\" }\n");
  const Result r = run("compare " + model + " " + rig + "train.csv");
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("did you mean speed_rpm?"));
}

}  // namespace
}  // namespace raceway::tests
