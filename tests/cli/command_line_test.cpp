#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/run_program.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

TEST(CommandLine, TellsItsVersion) {
  const Result r = run("--version");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, HasSubstr("raceway 0.1.0"));
}

}  // namespace
}  // namespace raceway::tests
