#include "io/timestamp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raceway::io {
namespace {

TEST(Timestamp, IsoAndGermanDatesAreOneTime) {
  // date -u -d "2024-03-12 08:15:00" +%s
  constexpr double expected = 1710231300.0;
  for (const char* text : {"2024-03-12T08:15:00", "2024-03-12 08:15", "2024-03-12T08:15:00Z",
                           "2024-03-12T09:15:00+01:00", "2024-03-12T08:15:00.000",
                           "12.03.2024 08:15:00", "12.3.2024 8:15"}) {
    const auto time = parse_timestamp(text);
    ASSERT_TRUE(time) << text;
    EXPECT_DOUBLE_EQ(*time, expected) << text;
  }
  EXPECT_DOUBLE_EQ(*parse_timestamp("12.03.2024 08:15:00,25"), expected + 0.25);
  EXPECT_EQ(timestamp_text(expected + 0.25), "2024-03-12T08:15:00.250");
}

TEST(Timestamp, WhatIsNoDateIsNone) {
  for (const char* text :
       {"", "12", "12.5", "2024-02-30T00:00:00", "32.01.2024 00:00:00", "03/12/2024 08:15:00",
        "2024-03-12", "2024-03-12T08:61:00", "12.03.2024 08:15:00x", "2024-03-12T25:00:00"})
    EXPECT_FALSE(parse_timestamp(text)) << text;
}

TEST(Timestamp, ExcelCountsDaysFrom1900) {
  // Excel shows 45363.34375 as 2024-03-12 08:15:00, and 1 as 1900-01-01.
  EXPECT_DOUBLE_EQ(seconds_of_excel(45363.34375).value(), 1710231300.0);
  EXPECT_EQ(timestamp_text(seconds_of_excel(1).value()), "1900-01-01T00:00:00");
  EXPECT_EQ(timestamp_text(seconds_of_excel(61).value()), "1900-03-01T00:00:00");
}

/// A number of days beyond any calendar had been printed as a year of nonsense.
TEST(Timestamp, ExcelHasTheYears1900To9999) {
  for (const double days : {-1.0, 2958466.0, 1e300, -1e300, std::nan(""), HUGE_VAL})
    EXPECT_FALSE(seconds_of_excel(days)) << days;
  EXPECT_EQ(timestamp_text(seconds_of_excel(2958465).value()), "9999-12-31T00:00:00");
}

}  // namespace
}  // namespace raceway::io
