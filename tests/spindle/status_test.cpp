#include <gtest/gtest.h>

#include "spindle/spindle.h"

namespace raceway::spindle {
namespace {

TEST(SpindleStatus, EveryEndHasANameOfItsOwn) {
  EXPECT_EQ(name(Status::thermal_runaway), "thermal_runaway");
  EXPECT_EQ(name(Status::no_equilibrium), "no_equilibrium");
  EXPECT_EQ(name(Status::step_limit), "step_limit");
  EXPECT_EQ(name(Report{}.status), "not_run");
}

}  // namespace
}  // namespace raceway::spindle
