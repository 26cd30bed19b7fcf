#include "text/twelve_digits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace raceway::text {
namespace {

std::string written(double value) {
  char room[twelve_digits_room];
  return {room, write_12_digits(room, value)};
}

void expect_as_printf(double value) {
  ASSERT_EQ(written(value), fmt::format("{:.12g}", value)) << fmt::format("{:.17g}", value);
}

TEST(TwelveDigits, AreThoseOfPrintfForNumbersOfEverySize) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> exponent(-7.0, 15.0);
  for (int i = 0; i < 300000; ++i) {
    const double value = std::pow(10.0, exponent(random));
    expect_as_printf(value);
    expect_as_printf(-value);
  }
  for (int i = 0; i < 100000; ++i) expect_as_printf(std::bit_cast<double>(random()));
}

TEST(TwelveDigits, AreThoseOfPrintfInTheMiddleBetweenTwo) {
  std::mt19937_64 random(13);
  std::uniform_int_distribution<std::uint64_t> whole(100000000000ULL, 999999999999ULL);
  for (int i = 0; i < 100000; ++i)
    for (const double power : {1e-15, 1e-11, 1e-9, 1e-4, 1.0}) {
      const double middle = (static_cast<double>(whole(random)) + 0.5) * power;
      expect_as_printf(middle);
      expect_as_printf(std::nextafter(middle, 0.0));
      expect_as_printf(std::nextafter(middle, 1e300));
    }
}

TEST(TwelveDigits, AreThoseOfPrintfAtPowersOfTenAndForWhatIsNoNumber) {
  for (int e = -20; e <= 20; ++e) {
    const double power = std::pow(10.0, e);
    for (const double value : {power, std::nextafter(power, 0.0), std::nextafter(power, 1e300),
                               2.0 * power, 0.1 * power, 12.5 * power})
      expect_as_printf(value);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {0.0, -0.0, infinity, -infinity, std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::denorm_min()})
    expect_as_printf(value);
}

}  // namespace
}  // namespace raceway::text
