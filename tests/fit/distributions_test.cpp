#include "fit/distributions.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace raceway::fit {
namespace {

// Tables in print: Abramowitz and Stegun (1964), tables 26.1, 26.8, 26.9 and 26.10.
TEST(Distributions, AgreeWithTablesInPrint) {
  EXPECT_NEAR(chi_squared_above(10, 18.3070), 0.05, 1e-6);
  EXPECT_NEAR(chi_squared_below(10, 18.3070), 0.95, 1e-6);
  EXPECT_NEAR(f_above(3, 10, 3.7083), 0.05, 1e-5);
  EXPECT_NEAR(t_above(10, 2.22814), 0.025, 1e-6);
  EXPECT_NEAR(t_exceeded_with(10, 0.025), 2.22814, 1e-5);
  EXPECT_NEAR(normal_exceeded_with(0.025), 1.959964, 1e-6);
  EXPECT_NEAR(normal_quantile(0.025), -1.959964, 1e-6);
}

TEST(Distributions, RejectDegreesOfFreedomThatAreNone) {
  EXPECT_THROW((void)chi_squared_above(0, 1), std::domain_error);
  EXPECT_THROW((void)f_above(3, -1, 1), std::domain_error);
  EXPECT_THROW((void)t_exceeded_with(0, 0.1), std::domain_error);
}

}  // namespace
}  // namespace raceway::fit
