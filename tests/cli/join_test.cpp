#include <filesystem>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

const std::string power_folder = tests::source_dir() + "/data/corrections/power";

const std::string room =
    "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = \"room\"\n"
    "input = \"ambient_temperature_C\"\nsections = [{ gain_um_K = -3, time_constant_s = 7000 }]\n";

TEST(Join, ASumInAnotherFolderFindsTheTablesOfItsParts) {
  const ScratchFolder scratch;
  std::filesystem::create_directories(scratch.path() / "out");
  const std::string sum = scratch.file("out/sum.toml");
  const Result r = run("join " + power_folder + "/correction.toml " +
                       scratch.write("room.toml", room) + " -o " + sum);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr("2 channels"));
  EXPECT_THAT(
      r.err,
      HasSubstr("the trust in the joined correction is unknown: compare the correction with a "
                "record of the whole machine"));
  EXPECT_EQ(run("check " + sum).status, 0);
  EXPECT_EQ(run("correct " + sum + " " + power_folder + "/test.csv -o -").status, 0);
  EXPECT_THAT(run("join " + sum + " " + scratch.file("room.toml") + " -o " + sum).err,
              HasSubstr("sum.toml"));  // never over what it reads
}

TEST(Join, WhatIsWrongIsSaidAndNothingWritten) {
  const ScratchFolder scratch;
  const std::string one = scratch.write("room.toml", room), out = scratch.file("sum.toml");
  const Result alone = run("join " + one + " -o " + out);
  EXPECT_EQ(alone.status, 1);
  EXPECT_THAT(alone.err,
              HasSubstr("raceway join: only one file is given; name at least two corrections"));
  EXPECT_THAT(run("join " + one + " " + one + " -o " + out).err,
              HasSubstr("an earlier file also has a channel \"room\": rename one"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace raceway::tests
