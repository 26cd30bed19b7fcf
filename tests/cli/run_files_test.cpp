#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

/// No run writes over what it reads, nor two things into one file, whatever the flags and the path.
class RunFiles : public testing::Test {
 protected:
  /// Expects that the run, with and without --force, is refused and leaves `file` as it is.
  void expect_kept(
      const std::string& file, const std::string& arguments,
      const std::string& message =
          ": this run reads this file, so it cannot write to the same file; name another file") {
    const std::string before = file_text(file);
    for (const char* force : {"", " --force"}) {
      const Result r = run(arguments + force);
      EXPECT_EQ(r.status, 1) << arguments << force;
      EXPECT_THAT(r.err, HasSubstr(message)) << arguments << force;
      EXPECT_EQ(r.out, "") << arguments << force;
      EXPECT_EQ(file_text(file), before) << arguments << force;
    }
  }
  ScratchFolder scratch_;
  const std::string model_ = scratch_.write("my.toml", model_text);
  const std::string data_ = scratch_.write("rig.csv", data_text);
  const std::string table_ = "table " + model_ + " --speed 0,1000 --axial-load 100 ";
};

TEST_F(RunFiles, NoCommandWritesOverItsModel) {
  expect_kept(model_, table_ + "-o " + model_);
  expect_kept(model_, table_ + "--report " + model_);
  expect_kept(model_, "compare " + model_ + " " + data_ + " --report " + model_);
  expect_kept(model_, "diagnose " + model_ + " " + data_ + " --report " + model_);
  expect_kept(model_, "add " + model_ + " windage --data " + data_ + " --report " + model_);
  const std::string spindle = scratch_.write(
      "spindle.toml", file_text(tests::source_dir() + "/data/spindles/two_against_one.toml"));
  expect_kept(spindle, "displacement " + spindle + " --speed 0,1000 -o " + spindle);
  expect_kept(spindle, "displacement " + spindle + " --speed 0,1000 --report " + spindle);
}

TEST_F(RunFiles, NoCommandWritesOverItsData) {
  expect_kept(data_, "calibrate " + model_ + " " + data_ + " -o " + data_);
  expect_kept(data_, "add " + model_ + " windage --data " + data_ + " -o " + data_);
  expect_kept(data_, "compare " + model_ + " " + data_ + " --report " + data_);
  expect_kept(data_, table_ + "--data " + data_ + " --report " + data_);
  expect_kept(data_, "fit-law " + data_ + " -o " + data_);
  expect_kept(data_, "fit-law -o " + data_ + " < " + data_);
  run(table_ + "--slab 1/2 -o " + scratch_.file("1.csv"));
  run(table_ + "--slab 2/2 -o " + scratch_.file("2.csv"));
  expect_kept(scratch_.file("2.csv"), "table --merge " + scratch_.file("1.csv") + " " +
                                          scratch_.file("2.csv") + " -o " + scratch_.file("2.csv"));
}

TEST_F(RunFiles, OtherPathsOfOneFileAreSeenThrough) {
  std::filesystem::create_symlink("my.toml", scratch_.file("link.toml"));
  std::filesystem::create_hard_link(model_, scratch_.file("hard.toml"));
  std::filesystem::create_directory(scratch_.file("sub"));
  std::filesystem::create_directory_symlink(scratch_.path(), scratch_.file("sub/up"));
  for (const char* path : {"link.toml", "hard.toml", "sub/../my.toml", "./my.toml",
                           "sub/up/my.toml", "sub/up/link.toml"})
    expect_kept(model_, table_ + "-o " + scratch_.file(path));
  expect_kept(model_, replaced(table_, "my.toml", "link.toml") + "-o " + model_);
}

TEST_F(RunFiles, TwoOutputsAreTwoFiles) {
  for (const char* other : {"x", "./x"}) {
    const std::string first = scratch_.file("x"), second = scratch_.file(other);
    expect_kept(first, table_ + "-o " + first + " --report " + second,
                "is named by --output and by --report; name two files");
    EXPECT_FALSE(std::filesystem::exists(first));
  }
  const Result streams = run(table_ + "-o /dev/null --report /dev/null");
  EXPECT_EQ(streams.status, 0) << streams.err;
}

TEST_F(RunFiles, CalibrateAndAddImproveTheirOwnModel) {
  std::filesystem::create_symlink("my.toml", scratch_.file("link.toml"));
  const Result kept = run("calibrate " + model_ + " " + data_ + " -o " + model_);
  expect_refused(kept, model_ + ": exists already; --force replaces it");
  EXPECT_EQ(file_text(model_), model_text);
  const Result calibrated =
      run("calibrate " + model_ + " " + data_ + " --force -o " + scratch_.file("link.toml"));
  EXPECT_EQ(calibrated.status, 0) << calibrated.err;
  EXPECT_THAT(file_text(model_), HasSubstr("[calibration"));
}

TEST_F(RunFiles, AddImprovesItsOwnModelToo) {
  const std::string rig = tests::source_dir() + "/tests/hidden_effect/rigs/dev-03/";
  const std::string model = scratch_.write("rig.toml", file_text(rig + "model.toml"));
  const Result added =
      run("add " + model + " lubricant-drag --data " + rig + "train.csv --force -o " + model);
  EXPECT_EQ(added.status, 0) << added.err;
  EXPECT_THAT(file_text(model), HasSubstr("lubricant-drag"));
}

TEST_F(RunFiles, ModelsOfSeveralRecordsAreNoDataEither) {
  const std::string second = scratch_.write("b.csv", data_text);
  const std::string run_of_all = "calibrate " + model_ + " " + data_ + " " + second + " " +
                                 scratch_.file("fit-rig.csv") + " --per-record f0 -o " +
                                 scratch_.file("fit.csv");
  scratch_.write("fit-rig.csv", data_text);
  expect_kept(scratch_.file("fit-rig.csv"), run_of_all);
}

}  // namespace
}  // namespace raceway::tests
