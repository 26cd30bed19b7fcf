#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace raceway::text {

/// Order of a date with slashes or dashes: 12/03/2024 is in March or in December, and 24/09/11 may
/// begin with its year, also with dots.
enum class DateOrder { day_first, month_first, year_first };
inline constexpr std::array date_orders{DateOrder::day_first, DateOrder::month_first,
                                        DateOrder::year_first};
/// Name for messages: "day first".
[[nodiscard]] std::string_view name(DateOrder order);

/// A date with a time as seconds since 1970, leap seconds left out: "2024-03-12T08:15:00.5+01:00"
/// (ISO 8601; a blank for the T, Z, no seconds), "20240312T081500", "2024/03/12 08:15", "12.03.2024
/// 08:15:00,5", "12-03-24 08:15", "12-Mar-2024 08:15:00", "Mar 12, 2024 8:15 AM", "03/12/2024
/// 08:15:00.5 AM", "Tue Mar 12 08:15:00 2024" of ctime(), with or without the name of its zone,
/// which is ignored; "20240312081500" and "202403120815" of the years 1970 to 2099. Names of months
/// are English or German, of three letters or more. Years of two digits are 1969 to 2068. Nothing
/// for all else.
[[nodiscard]] std::optional<double> parse_timestamp(std::string_view cell,
                                                    DateOrder order = DateOrder::day_first);

/// True if a date states its zone, as "2024-03-12T08:15:00Z" and "...+01:00" do.
[[nodiscard]] bool has_zone(std::string_view cell);

/// A date without a time, in the forms of parse_timestamp(), as seconds since 1970.
[[nodiscard]] std::optional<double> parse_date(std::string_view cell,
                                               DateOrder order = DateOrder::day_first);

/// A time of day without a date [s]: "20:15", "20:15:00.5", "8:15:00 PM".
[[nodiscard]] std::optional<double> parse_clock(std::string_view cell);

/// An elapsed time [s]: "1:30:05.5", "100:00:00", "12:05.0" of minutes, with days in front "2
/// 01:30:05", "2 days 01:30:05", "2.01:30:05". Nothing for other texts.
[[nodiscard]] std::optional<double> parse_elapsed(std::string_view cell);

/// "12:05", which may be hours and minutes or minutes and seconds.
struct ShortTime {
  int units = 0;      ///< hours or minutes
  int sixtieths = 0;  ///< minutes or seconds
};
/// Reads such a time. Nothing for other texts.
[[nodiscard]] std::optional<ShortTime> parse_short_time(std::string_view cell);

/// True if a cell is a date with a time, in either order, an elapsed time, "12:05", or a time of
/// day with AM or PM.
[[nodiscard]] bool is_time(std::string_view cell);

/// True if a clock change may lie between two local times: on the last Sunday of March and of
/// October (Europe), the second of March and the first of November (North America), the last of
/// September or the first of October and the first of April (New Zealand, Australia), in the night.
/// `forward`: to summer time.
[[nodiscard]] bool clocks_may_change(double before, bool forward);

/// Days since 1900 as Excel counts them (60 is 29 February 1900, which did not exist), as seconds
/// since 1970. Nothing outside of Excel's years, 1900 to 9999.
[[nodiscard]] std::optional<double> seconds_of_excel(double days);

/// Returns "2024-03-12T08:15:00.5"; for the years 0 to 9999.
[[nodiscard]] std::string timestamp_text(double seconds);

}  // namespace raceway::text
