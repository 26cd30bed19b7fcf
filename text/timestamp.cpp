#include "text/timestamp.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "text/names.h"

namespace raceway::text {
namespace {

namespace chrono = std::chrono;

constexpr double day = 86400.0;

/// Takes a text from its front, piece by piece; failed once a piece is not there.
class Scan {
  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

 public:
  explicit Scan(std::string_view text) : rest_(text) {}

  /// A number of that many digits.
  int digits(std::size_t least, std::size_t most) {
    int value = 0;
    std::size_t count = 0;
    while (count < most && count < rest_.size() && rest_[count] >= '0' && rest_[count] <= '9')
      value = 10 * value + (rest_[count++] - '0');
    failed_ = failed_ || count < least;
    rest_.remove_prefix(count);
    return value;
  }
  /// Of four digits, or of two from 1969 to 2068.
  int year() {
    const std::size_t count = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    const int value = digits(count == 2 ? 2 : 4, 4);
    return count != 2 ? value : value < 69 ? 2000 + value : 1900 + value;
  }
  void skip(std::size_t count) { rest_.remove_prefix(std::min(count, rest_.size())); }
  /// Any one of these.
  bool maybe(std::string_view marks) {
    if (rest_.empty() || marks.find(rest_.front()) == marks.npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void need(std::string_view marks) { failed_ = !maybe(marks) || failed_; }
  /// What stands behind the decimal mark of a number.
  double fraction() {
    double value = 0.0, place = 0.1;
    if (rest_.empty() || rest_.front() < '0' || rest_.front() > '9') failed_ = true;
    for (; !rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9'; place /= 10.0) {
      value += place * (rest_.front() - '0');
      rest_.remove_prefix(1);
    }
    return value;
  }
  /// 'A' or 'P' of "AM" and "PM" behind a blank or none.
  std::optional<char> half_of_day() {
    const std::string rest = lower_case(rest_);
    for (const std::string_view ending : {" am", " pm", "am", "pm"})
      if (rest == ending) {
        rest_ = {};
        return ending[ending.size() - 2] == 'a' ? 'A' : 'P';
      }
    return std::nullopt;
  }
  /// The number of a month by three letters of its name or more; 0 for none.
  int month() {
    std::size_t size = 0;
    while (size < rest_.size() && (is_letter(rest_[size]) || (rest_[size] & 0x80) != 0)) ++size;
    const std::string name = lower_case(rest_.substr(0, size));
    rest_.remove_prefix(size);
    constexpr std::array names{"january januar",  "february februar", "march m\u00e4rz maerz mrz",
                               "april",           "may mai",          "june juni",
                               "july juli",       "august",           "september",
                               "october oktober", "november",         "december dezember"};
    for (std::size_t k = 0; name.size() >= 3 && k < names.size(); ++k) {
      const std::string all = std::string(" ") + names[k];
      if (all.find(" " + name) != all.npos) return static_cast<int>(k) + 1;
    }
    failed_ = true;
    return 0;
  }
  /// One blank or more; the digits of a day stand in columns.
  void need_blanks() {
    need(" ");
    while (maybe(" ")) continue;
  }
  /// "CEST" and blanks, where it stands here.
  void maybe_zone_name() {
    const std::size_t size =
        std::min(rest_.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), rest_.size());
    if (size < 3 || size > 5) return;
    skip(size);
    need_blanks();
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] char next() const { return rest_.empty() ? '\0' : rest_.front(); }
  [[nodiscard]] bool done() const { return !failed_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool failed_ = false;
};

/// "+01:00" of ISO 8601 [s].
double zone(Scan& scan) {
  if (scan.maybe("Z")) return 0.0;
  const double sign = scan.next() == '-' ? -1.0 : 1.0;
  if (!scan.maybe("+-")) return 0.0;
  const int hours = scan.digits(2, 2);
  scan.maybe(":");
  const int minutes = scan.next() == '\0' ? 0 : scan.digits(2, 2);
  return sign * (3600.0 * hours + 60.0 * minutes);
}

struct Date {
  int year = 0, month = 0, day = 0;
  bool compact = false;  ///< without marks, as the time behind it
  bool glued = false;    ///< its time follows at once
};

/// "Wed, " and "Wed ".
void skip_weekday(Scan& scan, std::string_view cell) {
  constexpr std::array<std::string_view, 14> names{"mon", "tue", "wed", "thu", "fri", "sat", "sun",
                                                   "mo",  "di",  "mi",  "do",  "fr",  "sa",  "so"};
  const std::string word = lower_case(cell.substr(0, cell.find_first_of(" ,.")));
  if (std::find(names.begin(), names.end(), word) == names.end()) return;
  scan.skip(word.size());
  scan.maybe(".");
  scan.maybe(",");
  scan.need(" ");
}

Date scan_date(Scan& scan, std::string_view cell, DateOrder order) {
  Date date;
  skip_weekday(scan, cell);
  cell = scan.rest();
  const std::size_t digits = std::min(cell.find_first_not_of("0123456789"), cell.size());
  const char mark = digits < cell.size() ? cell[digits] : '\0';
  const bool is_number_behind =
      digits + 1 < cell.size() && cell[digits + 1] >= '0' && cell[digits + 1] <= '9';
  if (digits == 8 || digits == 12 || digits == 14) {
    date.compact = true;
    date.glued = digits > 8;
    date.year = scan.digits(4, 4);
    date.month = scan.digits(2, 2);
    date.day = scan.digits(2, 2);
  } else if (digits == 4) {
    const bool iso = mark == '-';
    const std::string_view same = mark == '.' ? "." : mark == '/' ? "/" : "-";
    date.year = scan.digits(4, 4);
    scan.need(same);
    date.month = scan.digits(iso ? 2 : 1, 2);
    scan.need(same);
    date.day = scan.digits(iso ? 2 : 1, 2);
  } else if (digits == 0) {  // Mar 12, 2024
    date.month = scan.month();
    scan.need(" ");
    date.day = scan.digits(1, 2);
    scan.maybe(",");
    scan.need(" ");
    date.year = scan.year();
  } else if (mark == '.' || mark == '/' || (mark == '-' && is_number_behind)) {
    const std::string_view same = mark == '.' ? "." : mark == '/' ? "/" : "-";
    const bool year_first = order == DateOrder::year_first;
    year_first ? date.year = scan.year() : date.day = scan.digits(1, 2);
    scan.need(same);
    date.month = scan.digits(1, 2);
    scan.need(same);
    year_first ? date.day = scan.digits(1, 2) : date.year = scan.year();
    if (mark != '.' && order == DateOrder::month_first) std::swap(date.day, date.month);
  } else {
    date.day = scan.digits(1, 2);
    scan.need("- ");
    date.month = scan.month();
    scan.need("- ");
    date.year = scan.year();
  }
  return date;
}

/// [s]; nothing where there is no such day.
std::optional<double> seconds_of(const Date& date) {
  const chrono::year_month_day day_of{chrono::year(date.year),
                                      chrono::month(static_cast<unsigned>(date.month)),
                                      chrono::day(static_cast<unsigned>(date.day))};
  if (!day_of.ok()) return std::nullopt;
  return day * static_cast<double>(chrono::sys_days(day_of).time_since_epoch().count());
}

/// A time of day up to its zone [s].
std::optional<double> scan_clock(Scan& scan, bool compact) {
  int hour = scan.digits(compact ? 2 : 1, 2);
  if (!compact) scan.need(":");
  const int minute = scan.digits(2, 2);
  double second = 0.0;
  if (compact ? scan.next() >= '0' && scan.next() <= '9' : scan.maybe(":")) {
    second = scan.digits(2, 2);
    if (scan.maybe(".,")) second += scan.fraction();
  }
  if (const auto half = scan.half_of_day()) {
    if (hour < 1 || hour > 12) return std::nullopt;
    hour = hour % 12 + (*half == 'P' ? 12 : 0);
  }
  if (hour > 24 || minute > 59 || second >= 61.0) return std::nullopt;
  return 3600.0 * hour + 60.0 * minute + second;
}

/// "Tue Sep  3 20:24:11 2024" of ctime() and of date: the year stands behind the time of day. Names
/// of zones say nothing new of a local clock.
std::optional<double> parse_ctime(std::string_view cell) {
  Scan scan(cell);
  skip_weekday(scan, cell);
  Date date;
  date.month = scan.month();
  scan.need_blanks();
  date.day = scan.digits(1, 2);
  scan.need_blanks();
  const auto clock = scan_clock(scan, false);
  scan.need_blanks();
  scan.maybe_zone_name();
  date.year = scan.digits(4, 4);
  const auto days = seconds_of(date);
  if (!scan.done() || !clock || !days) return std::nullopt;
  return *days + *clock;
}

}  // namespace

std::string_view name(DateOrder order) {
  switch (order) {
    case DateOrder::day_first:
      return "day first";
    case DateOrder::month_first:
      return "month first";
    case DateOrder::year_first:
      break;
  }
  return "year first";
}

std::optional<double> parse_timestamp(std::string_view cell, DateOrder order) {
  if (!cell.empty() && (cell.front() & 0x40) != 0)
    if (const auto time = parse_ctime(cell)) return time;
  Scan scan(cell);
  const Date date = scan_date(scan, cell, order);
  if (date.glued) {
    if (date.year < 1970 || date.year > 2099) return std::nullopt;  // a counter
  } else if (scan.maybe(",")) {
    scan.need(" ");
  } else {
    scan.need("T ");
  }
  const auto clock = scan_clock(scan, date.compact);
  const double offset = zone(scan);
  const auto days = seconds_of(date);
  if (!scan.done() || !clock || !days) return std::nullopt;
  return *days + *clock - offset;
}

std::optional<double> parse_date(std::string_view cell, DateOrder order) {
  Scan scan(cell);
  const Date date = scan_date(scan, cell, order);
  return scan.done() ? seconds_of(date) : std::nullopt;
}

std::optional<double> parse_clock(std::string_view cell) {
  Scan scan(cell);
  const auto clock = scan_clock(scan, false);
  return scan.done() && clock && *clock < day ? clock : std::nullopt;
}

bool has_zone(std::string_view cell) {
  const std::size_t colon = cell.find(':'), time = colon != cell.npos ? colon : cell.find('T');
  return cell.ends_with('Z') || (time != cell.npos && cell.find_first_of("+-", time) != cell.npos);
}

std::optional<double> parse_elapsed(std::string_view cell) {
  Scan scan(cell);
  int days = 0, hours = 0;
  const std::size_t colon = cell.find(':');
  if (cell.find_first_of(" .") < colon) {
    days = scan.digits(1, 4);
    if (!scan.maybe(".")) {
      scan.need(" ");
      for (const std::string_view word : {"days ", "day "})
        if (scan.rest().starts_with(word)) {
          scan.skip(word.size());
          break;
        }
    }
  }
  const bool has_hours = colon != cell.npos && cell.find(':', colon + 1) != cell.npos;
  if (has_hours) {
    hours = scan.digits(1, 6);
    scan.need(":");
  }
  const int minutes = scan.digits(has_hours ? 2 : 1, has_hours ? 2 : 6);
  scan.need(":");
  double seconds = scan.digits(2, 2);
  // 12:05 may be minutes or hours, 12:05.0 is minutes.
  if (scan.maybe(".,"))
    seconds += scan.fraction();
  else if (!has_hours)
    return std::nullopt;
  if (!scan.done() || (has_hours && minutes > 59) || seconds >= 60.0) return std::nullopt;
  return day * days + 3600.0 * hours + 60.0 * minutes + seconds;
}

std::optional<ShortTime> parse_short_time(std::string_view cell) {
  Scan scan(cell);
  ShortTime time;
  time.units = scan.digits(1, 6);
  scan.need(":");
  time.sixtieths = scan.digits(2, 2);
  return scan.done() && time.sixtieths < 60 ? std::optional(time) : std::nullopt;
}

bool is_time(std::string_view cell) {
  return std::any_of(date_orders.begin(), date_orders.end(),
                     [&](DateOrder order) { return parse_timestamp(cell, order).has_value(); }) ||
         parse_elapsed(cell) || parse_short_time(cell) ||
         (lower_case(cell).ends_with('m') && parse_clock(cell));
}

bool clocks_may_change(double before, bool forward) {
  const double days = std::floor(before / day);
  if (!(std::abs(days) < 4e6)) return false;
  const chrono::sys_days date{chrono::days(static_cast<int>(days))};
  const chrono::year_month_day parts{date};
  if (chrono::weekday(date) != chrono::Sunday) return false;
  const unsigned month = static_cast<unsigned>(parts.month()),
                 of_month = static_cast<unsigned>(parts.day());
  const double hour = (before - day * days) / 3600.0;
  const bool first = of_month<8, second = of_month> 7 && of_month<15, last_of_30 = of_month> 23,
             last_of_31 = of_month > 24;
  if (forward)
    return hour < 3.0 && ((month == 3 && (second || last_of_31)) || (month == 9 && last_of_30) ||
                          (month == 10 && first));
  return hour >= 1.0 && hour < 4.0 &&
         ((month == 10 && last_of_31) || (month == 11 && first) || (month == 4 && first));
}

std::optional<double> seconds_of_excel(double days) {
  constexpr double of_1970 = 25569.0, of_10000 = 2958466.0;
  if (!(days >= 0.0 && days < of_10000)) return std::nullopt;
  return (days - of_1970 + (days < 60.0 ? 1.0 : 0.0)) * day;
}

std::string timestamp_text(double seconds) {
  // Numbers of Excel are good for some microseconds.
  seconds = std::round(seconds * 1e3) / 1e3;
  const double days = std::floor(seconds / day);
  const chrono::year_month_day date{chrono::sys_days{chrono::days(static_cast<int>(days))}};
  const double rest = std::round((seconds - day * days) * 1e3) / 1e3;
  const int minutes = static_cast<int>(rest / 60.0);
  std::string second = fmt::format("{:06.3f}", rest - 60.0 * minutes);
  if (second.ends_with(".000")) second.resize(2);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     minutes / 60, minutes % 60, second);
}

}  // namespace raceway::text
