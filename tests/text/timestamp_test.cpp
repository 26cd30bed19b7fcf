#include "text/timestamp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raceway::text {
namespace {

TEST(Timestamp, IsoAndGermanDatesAreOneTime) {
  // date -u -d "2024-03-12 08:15:00" +%s
  constexpr double expected = 1710231300.0;
  for (const char* text : {"2024-03-12T08:15:00",
                           "2024-03-12 08:15",
                           "2024-03-12T08:15:00Z",
                           "2024-03-12T09:15:00+01:00",
                           "2024-03-12T08:15:00.000",
                           "12.03.2024 08:15:00",
                           "12.3.2024 8:15",
                           "20240312T081500",
                           "20240312T0815Z",
                           "2024/03/12 08:15:00",
                           "2024/3/12 8:15",
                           "12-Mar-2024 08:15:00",
                           "12 MARCH 2024 08:15",
                           "12-Mrz-2024 8:15:00",
                           "12-M\u00e4r-2024 8:15",
                           "12/03/2024 08:15:00",
                           "12.03.24 08:15:00",
                           "12/03/24 08:15",
                           "12-Mar-24 08:15",
                           "12-03-2024 08:15:00",
                           "2024.03.12 08:15",
                           "20240312081500",
                           "202403120815",
                           "Mar 12, 2024 08:15:00 AM",
                           "Tue, 12 Mar 2024 08:15:00",
                           "2024-03-12, 08:15:00",
                           "12/03/2024 08:15:00 AM",
                           "12.03.2024 8:15am"}) {
    const auto time = parse_timestamp(text);
    ASSERT_TRUE(time) << text;
    EXPECT_DOUBLE_EQ(*time, expected) << text;
  }
  EXPECT_DOUBLE_EQ(*parse_timestamp("12.03.2024 08:15:00,25"), expected + 0.25);
  EXPECT_EQ(timestamp_text(expected + 0.25), "2024-03-12T08:15:00.250");
  // Just before midnight is midnight, within the precision of Excel.
  EXPECT_EQ(timestamp_text(parse_timestamp("2024-03-13 00:00").value() - 1e-5),
            "2024-03-13T00:00:00");
  EXPECT_DOUBLE_EQ(*parse_timestamp("03/12/2024 08:15:00", DateOrder::month_first), expected);
  EXPECT_DOUBLE_EQ(*parse_timestamp("12/03/2024 08:15:00.5 PM"), expected + 12 * 3600.0 + 0.5);
  EXPECT_DOUBLE_EQ(*parse_timestamp("12/03/2024 12:15:00 AM"), expected - 8 * 3600.0);
  EXPECT_DOUBLE_EQ(*parse_timestamp("12/03/2024 12:15:00 PM"), expected + 4 * 3600.0);
}

TEST(Timestamp, YearsOfTwoDigitsMayStandInFront) {
  // date -u -d '2024-09-11 20:15' +%s
  for (const char* text : {"24/09/11 20:15", "24-9-11 20:15:00", "24.09.11 8:15 PM"})
    EXPECT_DOUBLE_EQ(parse_timestamp(text, DateOrder::year_first).value(), 1726085700.0) << text;
  EXPECT_EQ(timestamp_text(parse_timestamp("24/09/11 20:15").value()), "2011-09-24T20:15:00");
  EXPECT_FALSE(parse_timestamp("11/09/2024 20:15", DateOrder::year_first));
  EXPECT_TRUE(is_time("99/09/30 20:15"));
}

// A counter of microseconds is no date.
TEST(Timestamp, DigitsAloneAreADateOfOurTimesOrNone) {
  for (const char* text : {"20240312081560000", "2024031208150", "19690312081500", "21000312081500",
                           "20241312081500", "20240312251500", "17260782930000", "1726078293"})
    EXPECT_FALSE(is_time(text)) << text;
}

TEST(Timestamp, WhatIsNoDateIsNone) {
  for (const char* text :
       {"", "12", "12.5", "2024-02-30T00:00:00", "32.01.2024 00:00:00", "03/13/2024 08:15:00",
        "12-Abc-2024 08:15:00", "12-Ma-2024 08:15:00", "12/03/2024 13:15:00 AM",
        "12/03/2024 00:15 PM", "2024/03-12 08:15", "20240312 8:15x", "2024-03-12",
        "2024-03-12T08:61:00", "12.03.2024 08:15:00x", "2024-03-12T25:00:00"})
    EXPECT_FALSE(parse_timestamp(text)) << text;
}

TEST(Timestamp, CtimeHasTheYearBehindTheTime) {
  const double time = parse_timestamp("2024-09-11T20:24:11").value();
  for (const char* text : {"Wed Sep 11 20:24:11 2024", "Sep 11 20:24:11 2024",
                           "Wed Sep 11 20:24:11 CEST 2024", "Mi Sep 11 20:24:11 2024"})
    EXPECT_EQ(parse_timestamp(text), time) << text;
  EXPECT_EQ(parse_timestamp("Sun Sep  1 20:24:11.5 2024"), time - 10 * 86400.0 + 0.5);
  for (const char* text : {"Wed Sep 11 20:24:11", "Wed Sep 31 20:24:11 2024",
                           "Wed Sep 11 25:24:11 2024", "Wed Sep 11 20:24:11 24"})
    EXPECT_FALSE(parse_timestamp(text)) << text;
}

TEST(Timestamp, TwoNumbersMayBeHoursOrMinutes) {
  EXPECT_EQ(parse_short_time("100:05").value().units, 100);
  EXPECT_EQ(parse_short_time("1:05").value().sixtieths, 5);
  EXPECT_TRUE(is_time("1:05"));
  for (const char* text : {"", "1:5", "1:60", "1:05:00", "1:05.0", "-1:05"})
    EXPECT_FALSE(parse_short_time(text)) << text;
}

TEST(Timestamp, ElapsedTimesAreHoursMinutesAndSeconds) {
  EXPECT_DOUBLE_EQ(parse_elapsed("1:30:05.5").value(), 5405.5);
  EXPECT_DOUBLE_EQ(parse_elapsed("100:00:00").value(), 360000.0);
  EXPECT_DOUBLE_EQ(parse_elapsed("2 01:30:05").value(), 2 * 86400.0 + 5405.0);
  EXPECT_DOUBLE_EQ(parse_elapsed("2 days 01:30:05").value(), 2 * 86400.0 + 5405.0);
  EXPECT_DOUBLE_EQ(parse_elapsed("1 day 01:30:05.5").value(), 86400.0 + 5405.5);
  EXPECT_DOUBLE_EQ(parse_elapsed("2.01:30:05").value(), 2 * 86400.0 + 5405.0);
  EXPECT_DOUBLE_EQ(parse_elapsed("90:05.5").value(), 5405.5);
  for (const char* text : {"", "1:30", "1:60:00", "1:00:60", "-1:00:00", "1:00:00x", "2  1:00:00"})
    EXPECT_FALSE(parse_elapsed(text)) << text;
}

TEST(Timestamp, YearsOfTwoDigitsAre1969To2068) {
  EXPECT_EQ(timestamp_text(parse_timestamp("01.01.68 00:00").value()), "2068-01-01T00:00:00");
  EXPECT_EQ(timestamp_text(parse_timestamp("01.01.69 00:00").value()), "1969-01-01T00:00:00");
  EXPECT_FALSE(parse_timestamp("01.01.124 00:00"));
}

TEST(Timestamp, DatesAndTimesOfDayMayStandAlone) {
  EXPECT_DOUBLE_EQ(parse_date("12.03.2024").value(), 1710201600.0);  // date -u -d 2024-03-12 +%s
  EXPECT_DOUBLE_EQ(parse_date("03/12/24", DateOrder::month_first).value(), 1710201600.0);
  EXPECT_FALSE(parse_date("12.03.2024 08:15"));
  EXPECT_DOUBLE_EQ(parse_clock("20:15").value(), 72900.0);
  EXPECT_DOUBLE_EQ(parse_clock("8:15:00.5 PM").value(), 72900.5);
  for (const char* text : {"", "8", "24:00:00", "13:15 PM", "8:15 XM"})
    EXPECT_FALSE(parse_clock(text));
}

/// Of 2024: Europe on 31 March and 27 October, North America on 10 March and 3 November.
TEST(Timestamp, ClocksChangeInTheNightOfSomeSundays) {
  const auto may = [](const char* before, bool forward) {
    return clocks_may_change(parse_timestamp(before).value(), forward);
  };
  EXPECT_TRUE(may("2024-03-31 01:59", true) && may("2024-10-27 02:59", false));
  EXPECT_TRUE(may("2024-03-10 01:59", true) && may("2024-11-03 01:59", false));
  // Australia on 7 April and 6 October, New Zealand on 7 April and 29 September.
  EXPECT_TRUE(may("2024-10-06 01:59", true) && may("2024-09-29 01:59", true));
  EXPECT_TRUE(may("2024-04-07 02:59", false));
  EXPECT_FALSE(may("2024-03-31 01:59", false) || may("2024-10-27 02:59", true));
  EXPECT_FALSE(may("2024-03-30 01:59", true) || may("2024-03-31 05:59", true) ||
               may("2024-10-20 02:59", false));
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
}  // namespace raceway::text
