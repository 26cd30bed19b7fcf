#include "io/timestamp.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace raceway::io {
namespace {

namespace chrono = std::chrono;

constexpr double day = 86400.0;

/// Takes a text from its front, piece by piece; failed once a piece is not there.
class Scan {
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

}  // namespace

std::optional<double> parse_timestamp(std::string_view cell) {
  Scan scan(cell);
  const bool german = cell.size() > 2 && (cell[1] == '.' || cell[2] == '.');
  int y = 0, m = 0, d = 0;
  if (german) {
    d = scan.digits(1, 2);
    scan.need(".");
    m = scan.digits(1, 2);
    scan.need(".");
    y = scan.digits(4, 4);
  } else {
    y = scan.digits(4, 4);
    scan.need("-");
    m = scan.digits(2, 2);
    scan.need("-");
    d = scan.digits(2, 2);
  }
  scan.need(german ? " " : "T ");
  const int hour = scan.digits(german ? 1 : 2, 2);
  scan.need(":");
  const int minute = scan.digits(2, 2);
  double second = 0.0;
  if (scan.maybe(":")) {
    second = scan.digits(2, 2);
    if (scan.maybe(german ? ",." : ".,")) second += scan.fraction();
  }
  const double offset = german ? 0.0 : zone(scan);
  if (!scan.done() || hour > 24 || minute > 59 || second >= 61.0) return std::nullopt;
  const chrono::year_month_day date{chrono::year(y), chrono::month(static_cast<unsigned>(m)),
                                    chrono::day(static_cast<unsigned>(d))};
  if (!date.ok()) return std::nullopt;
  const auto days = chrono::sys_days(date).time_since_epoch().count();
  return day * static_cast<double>(days) + 3600.0 * hour + 60.0 * minute + second - offset;
}

std::optional<double> seconds_of_excel(double days) {
  constexpr double of_1970 = 25569.0, of_10000 = 2958466.0;
  if (!(days >= 0.0 && days < of_10000)) return std::nullopt;
  return (days - of_1970 + (days < 60.0 ? 1.0 : 0.0)) * day;
}

std::string timestamp_text(double seconds) {
  const double days = std::floor(seconds / day);
  const chrono::year_month_day date{chrono::sys_days{chrono::days(static_cast<int>(days))}};
  // Numbers of Excel are good for some microseconds.
  const double rest = std::round((seconds - day * days) * 1e3) / 1e3;
  const int minutes = static_cast<int>(rest / 60.0);
  std::string second = fmt::format("{:06.3f}", rest - 60.0 * minutes);
  if (second.ends_with(".000")) second.resize(2);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     minutes / 60, minutes % 60, second);
}

}  // namespace raceway::io
