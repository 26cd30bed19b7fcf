#pragma once

#include <gtest/gtest.h>

#include <cmath>

namespace raceway::tests {

inline void expect_relative(double value, double reference, double relative_tolerance) {
  EXPECT_NEAR(value, reference, relative_tolerance * std::abs(reference));
}

}  // namespace raceway::tests
