#include "cli/text_bars.h"

#include <gtest/gtest.h>

#include "tests/cli/sample.h"

namespace raceway::cli {
namespace {

TEST(TextBars, AreAsLongAsTheirShare) {
  EXPECT_EQ(bar(10.0, 10.0, 8), "########");
  EXPECT_EQ(bar(5.0, 10.0, 8), "####");
  EXPECT_EQ(bar(0.001, 10.0, 8), "#") << "something is not nothing";
  EXPECT_EQ(bar(0.0, 10.0, 8), "");
  EXPECT_EQ(bar(-3.0, 10.0, 8), "");
  EXPECT_EQ(bar(20.0, 10.0, 8), "########");
}

TEST(TextBars, ShowAMarkWhetherTheyReachItOrNot) {
  EXPECT_EQ(bar(2.0, 8.0, 8, 5.0), "##  |");
  EXPECT_EQ(bar(6.0, 8.0, 8, 5.0), "####|#");
  EXPECT_EQ(bar(0.0, 8.0, 8, 1.0), "|");
  EXPECT_EQ(bar(2.0, 8.0, 8, 9.0), "##") << "outside";
}

TEST(TextBars, ShowASecondMarkBesideTheFirst) {
  EXPECT_EQ(bar(6.0, 8.0, 8, 2.0, 5.0), "#|##:#");
  EXPECT_EQ(bar(2.0, 8.0, 8, 3.0, 5.0), "##| :");
  EXPECT_EQ(bar(2.0, 8.0, 8, 5.0, 5.0), "##  :") << "at the same place";
  EXPECT_EQ(bar(2.0, 8.0, 8, 3.0, std::nan("")), "##|");
}

TEST(TextBars, OfNumbersThatAreNotKnownAreEmpty) {
  EXPECT_EQ(bar(std::nan(""), 8.0, 8), "");
  EXPECT_EQ(bar(1.0, 0.0, 8), "");
  EXPECT_EQ(bar(1.0, std::nan(""), 8), "");
  EXPECT_EQ(bar(2.0, 8.0, 8, std::nan("")), "##");
}

TEST(TextBars, AFileGetsNoColour) {
  EXPECT_EQ(tests::run("effects").out.find('\x1b'), std::string::npos);
}

/// What a command prints on a terminal of 100 columns; `environment` such as "NO_COLOR=1".
std::string on_terminal(const std::string& arguments, const std::string& environment = "") {
  const tests::Result r =
      tests::run_shell("TERM=xterm " + environment + " script -qec \"stty cols 100; $raceway " +
                       arguments + "\" /dev/null </dev/null");
  EXPECT_EQ(r.status, 0) << r.out << r.err;
  std::string text = r.out;
  std::erase(text, '\r');
  return text;
}

TEST(TextBars, ATerminalGetsColourUnlessNoColorSaysOtherwise) {
  if (tests::run_shell("command -v script").status != 0) GTEST_SKIP() << "no script(1)";
  const tests::ScratchFolder scratch;
  const std::string files = scratch.write("my.toml", tests::model_text) + " " +
                            scratch.write("rig.csv", tests::data_text) + " 2>/dev/null";
  const std::string plain = tests::run("compare " + files).out;
  ASSERT_NE(plain, "");
  EXPECT_EQ(plain.find('\x1b'), std::string::npos) << "a file";
  const std::string coloured = on_terminal("compare " + files);
  EXPECT_NE(coloured.find("\x1b[3"), std::string::npos) << coloured;
  EXPECT_NE(coloured.find("\x1b[0m"), std::string::npos) << coloured;
  EXPECT_EQ(on_terminal("compare " + files, "NO_COLOR=1"), plain);
  EXPECT_EQ(on_terminal("compare " + files, "TERM=dumb"), plain);
  EXPECT_NE(on_terminal("compare " + files, "NO_COLOR=").find('\x1b'), std::string::npos)
      << "set but empty, as no-color.org has it";
}

}  // namespace
}  // namespace raceway::cli
