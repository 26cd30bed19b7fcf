#include "record/digits.h"

#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

namespace raceway::record {
namespace {

using Limits = std::numeric_limits<double>;

TEST(WithDigits, RoundsToTheNearest) {
  EXPECT_EQ(with_digits(6000.000000000001, 15), 6000.0);
  EXPECT_EQ(with_digits(1.926, 3), 1.93);
  EXPECT_EQ(with_digits(-0.00169, 2), -0.0017);
  EXPECT_EQ(with_digits(0.95, 1), 0.9);  // 0.95 is below 0.95 in binary
  EXPECT_TRUE(std::signbit(with_digits(-0.0, 7)));
}

TEST(WithDigits, LeavesWhatHasNoDigits) {
  EXPECT_TRUE(std::isnan(with_digits(Limits::quiet_NaN(), 7)));
  EXPECT_EQ(with_digits(-Limits::infinity(), 7), -Limits::infinity());
  EXPECT_EQ(with_digits(Limits::max(), 2), Limits::max());
}

// The C library rounds and reads independently of this code.
TEST(WithDigits, AgreesWithTheCLibrary) {
  std::mt19937_64 bits(1);
  for (int i = 0; i < 100'000; ++i) {
    const double value = std::bit_cast<double>(bits());
    if (!std::isfinite(value)) continue;
    const int digits = 1 + i % 17;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    const double expected = std::strtod(text.data(), nullptr);
    EXPECT_EQ(with_digits(value, digits), std::isfinite(expected) ? expected : value)
        << text.data();
  }
}

}  // namespace
}  // namespace raceway::record
