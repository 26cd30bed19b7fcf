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

TEST(TextBars, OfNumbersThatAreNotKnownAreEmpty) {
  EXPECT_EQ(bar(std::nan(""), 8.0, 8), "");
  EXPECT_EQ(bar(1.0, 0.0, 8), "");
  EXPECT_EQ(bar(1.0, std::nan(""), 8), "");
  EXPECT_EQ(bar(2.0, 8.0, 8, std::nan("")), "##");
}

TEST(TextBars, AFileGetsNoColour) {
  EXPECT_EQ(tests::run("effects").out.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace raceway::cli
