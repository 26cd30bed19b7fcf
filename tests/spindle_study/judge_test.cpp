#include "tests/spindle_study/judge.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace spindle_study {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A folder with one spindle whose motor is hidden, and a program that always answers the same.
class SpindleStudyJudge : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("spindle_study_") +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "motor-heat-7");
    put(folder_ / "motor-heat-7" / "truth.json",
        R"({"hidden": {"motor-heat": 150}, "accept": ["motor-heat", "drive-heat"],
            "verdicts": ["effect", "ambiguous"], "signal": 2.5})");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static void put(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
  }

  [[nodiscard]] Outcome judged(const std::string& verdict, const std::string& explanations) const {
    const std::filesystem::path program = folder_ / "program";
    put(program, "#!/bin/sh\ncase \"$1\" in\ndiagnose) echo '{\"verdict\": \"" + verdict +
                     "\", \"sentence\": \"\", \"explanations\": " + explanations +
                     "}';;\ncompare) echo '{\"channels\": [{\"unit\": \"um\", \"rmse\": 0.5}, "
                     "{\"unit\": \"K\", \"rmse\": 0.2}, {\"unit\": \"K\", \"rmse\": 0.3}]}';;\n"
                     "add) test \"$3\" = motor-heat || { echo 'no such effect' >&2; exit 1; };;\n"
                     "esac\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const std::vector<Case> cases = cases_in(folder_, {&find_class("motor-heat")});
    return judge(cases.at(0), program.string());
  }

  std::filesystem::path folder_;
};

TEST_F(SpindleStudyJudge, ANameThatTheTruthAcceptsIsRight) {
  const Outcome o = judged("ambiguous", R"([["motor-heat"], ["coolant"]])");
  EXPECT_EQ(o.failure, "");
  EXPECT_TRUE(o.right());
  EXPECT_FALSE(o.wrong_name());
  EXPECT_EQ(o.after.displacement, 0.5);
  EXPECT_EQ(o.after.temperature, 0.3) << "the worst thermometer counts";
}

TEST_F(SpindleStudyJudge, AnotherNameIsWrongAndAFailureOfTheProgramIsTold) {
  const Outcome o = judged("effect", R"([["coolant"]])");
  EXPECT_FALSE(o.right());
  EXPECT_TRUE(o.wrong_name());
  EXPECT_EQ(o.failure, "no such effect");
  EXPECT_THAT(table({o}), HasSubstr("motor-heat"));
  EXPECT_THAT(line(o), HasSubstr("WRONG"));
}

TEST_F(SpindleStudyJudge, AMissedEffectIsNoWrongName) {
  const Outcome o = judged("nothing-missing", "[]");
  EXPECT_FALSE(o.right());
  EXPECT_FALSE(o.wrong_name());
  EXPECT_THAT(line(o), Not(HasSubstr("WRONG")));
}

TEST_F(SpindleStudyJudge, OnlyWishedClassesAreRead) {
  EXPECT_TRUE(cases_in(folder_, {&find_class("coolant")}).empty());
}

}  // namespace
}  // namespace spindle_study
