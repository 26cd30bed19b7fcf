#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace raceway::text {

/// Order of day, month and year in a date that is written in numbers only. Some dates are
/// ambiguous: 12/03/2024 can be in March or in December, and 24/09/11 and 24.09.11 can begin with
/// the day or the year. A date with dots, such as 12.03.2024, never begins with the month.
enum class DateOrder { day_first, month_first, year_first };
inline constexpr std::array date_orders{DateOrder::day_first, DateOrder::month_first,
                                        DateOrder::year_first};
/// Returns the order in words for messages, such as "day first".
[[nodiscard]] std::string_view name(DateOrder order);

/// Returns a date with a time as seconds since 1970 without leap seconds; empty for other texts.
/// The allowed forms are:
///
///   ISO 8601         "2024-03-12T08:15:00.5+01:00", also with a blank in place of T, with Z, or
///                    without seconds; "20240312T081500"
///   digits only      "20240312081500", "202403120815", for the years 1970 to 2099
///   date in numbers  "2024/03/12 08:15", "12.03.2024 08:15:00,5", "12-03-24 08:15",
///                    "03/12/2024 08:15:00.5 AM"
///   month as a word  "12-Mar-2024 08:15:00", "Mar 12, 2024 8:15 AM"
///   ctime()          "Tue Mar 12 08:15:00 2024"; the name of a time zone is allowed and ignored
///
/// Names of months are English or German and have at least three letters. Years of two digits mean
/// 1969 to 2068.
[[nodiscard]] std::optional<double> parse_timestamp(std::string_view cell,
                                                    DateOrder order = DateOrder::day_first);

/// Returns true if a date states its time zone, such as "2024-03-12T08:15:00Z" and "...+01:00".
[[nodiscard]] bool has_zone(std::string_view cell);

/// Returns a date without a time as seconds since 1970; empty for other texts. The date may have
/// the forms that parse_timestamp() accepts.
[[nodiscard]] std::optional<double> parse_date(std::string_view cell,
                                               DateOrder order = DateOrder::day_first);

/// Returns a time of day without a date as seconds since midnight: "20:15", "20:15:00.5", "8:15:00
/// PM". The result is empty for other texts.
[[nodiscard]] std::optional<double> parse_clock(std::string_view cell);

/// Returns an elapsed time [s]: "1:30:05.5", "100:00:00", "12:05.0" (12 min 5 s), or with days "2
/// 01:30:05", "2 days 01:30:05", "2.01:30:05". The result is empty for other texts.
[[nodiscard]] std::optional<double> parse_elapsed(std::string_view cell);

/// A time such as "12:05", which may be hours and minutes or minutes and seconds.
struct ShortTime {
  int units = 0;      ///< hours or minutes
  int sixtieths = 0;  ///< minutes or seconds
};
/// Parses a short time (see ShortTime). The result is empty for other texts.
[[nodiscard]] std::optional<ShortTime> parse_short_time(std::string_view cell);

/// Returns true if a cell is a date with a time (in any order of day, month and year), an elapsed
/// time, a short time such as "12:05", or a time of day with AM or PM.
[[nodiscard]] bool is_time(std::string_view cell);

/// Returns true if a change to or from summer time is possible at the local time `before`, in
/// seconds since 1970. The changes are at night on these Sundays: the last of March and of October
/// (Europe); the second of March and the first of November (North America); the last of September
/// or the first of October, and the first of April (New Zealand, Australia). If `forward` is true,
/// the function tests the change to summer time, otherwise the change from summer time.
[[nodiscard]] bool clocks_may_change(double before, bool forward);

/// Converts a date number of Excel (in days; 1 is 1 January 1900) to seconds since 1970. Number 60
/// of Excel is 29 February 1900, a date that did not exist; the function returns 28 February 1900.
/// The result is empty outside the years of Excel, 1900 to 9999.
[[nodiscard]] std::optional<double> seconds_of_excel(double days);

/// Returns seconds since 1970 as a text such as "2024-03-12T08:15:00.500", for the years 0 to 9999.
[[nodiscard]] std::string timestamp_text(double seconds);

}  // namespace raceway::text
