#include "fit/isolated_readings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "record/median.h"

namespace raceway::fit {

namespace {

constexpr std::size_t reach = 2;       // neighbours on either side
constexpr std::size_t longest = 2;     // rows in succession
constexpr double far_away = 6.0;       // robust standard deviations
constexpr double farther = 3.0;        // than the neighbours are from each other
constexpr double finest = 0.003;       // of the range of nine in ten readings
constexpr double impossible = 3.0;     // of the range of nearly all readings
constexpr double steady_speed = 0.01;  // of the largest
constexpr double neighbours = 3.0;     // median steps in time
constexpr double most_isolated = 0.1;  // of the readings
constexpr std::size_t fewest_steady = 30;
constexpr std::size_t most_lines = 20;  // that a statement lists

/// The readings of one channel in the order of their rows.
class Readings {
 public:
  Readings(const record::Record& record, const record::Column& column)
      : record_(record), values_(column.values) {
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (std::isfinite(values_[i])) rows_.push_back(i);
    std::vector<double> steps;
    for (std::size_t k = 1; k < rows_.size(); ++k) steps.push_back(step(k - 1, k));
    if (!steps.empty()) longest_step_ = neighbours * record::median(steps);
    for (const record::Column& setting : record.columns) {
      if (setting.channel->role != record::Role::setting || !setting.channel->ratio) continue;
      double largest = 0.0;
      for (const double v : setting.values) largest = std::fmax(largest, std::abs(v));
      set_.push_back({&setting, steady_speed * largest});
    }
  }

  [[nodiscard]] std::size_t count() const { return rows_.size(); }
  [[nodiscard]] std::size_t row(std::size_t k) const { return rows_[k]; }
  [[nodiscard]] double operator[](std::size_t k) const { return values_[rows_[k]]; }

  /// Whether nothing that is set changes over these readings, and none is missing between them.
  [[nodiscard]] bool steady(std::size_t first, std::size_t last) const {
    for (std::size_t k = first; k < last; ++k)
      if (record_.run_of(rows_[k]) != record_.run_of(rows_[k + 1]) ||
          !(step(k, k + 1) <= longest_step_))
        return false;
    return std::all_of(set_.begin(), set_.end(), [&](const auto& of) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t row = rows_[first]; row <= rows_[last]; ++row) {
        low = std::fmin(low, of.column->values[row]);
        high = std::fmax(high, of.column->values[row]);
      }
      return high - low <= of.step;
    });
  }

 private:
  [[nodiscard]] double step(std::size_t a, std::size_t b) const {
    return record_.value(record::time, rows_[b]) - record_.value(record::time, rows_[a]);
  }

  struct Setting {
    const record::Column* column;
    double step;  // that is none [SI]
  };

  const record::Record& record_;
  const std::vector<double>& values_;
  std::vector<Setting> set_{};
  std::vector<std::size_t> rows_{};
  double longest_step_ = 0.0;
};

/// Which stretches of readings about each reading are steady.
std::vector<bool> steady_ones(const Readings& readings) {
  std::vector<bool> steady(readings.count(), false);
  for (std::size_t k = reach; k + reach < readings.count(); ++k)
    steady[k] = readings.steady(k - reach, k + reach);
  return steady;
}

/// The readings in the order of their size; none for too few.
std::vector<double> by_size(const Readings& readings) {
  std::vector<double> all;
  if (readings.count() < fewest_steady) return all;
  for (std::size_t k = 0; k < readings.count(); ++k) all.push_back(readings[k]);
  std::sort(all.begin(), all.end());
  return all;
}

/// That nine in ten readings have.
double usual_range(const std::vector<double>& by_size) {
  return by_size.empty() ? 0.0 : by_size[by_size.size() * 19 / 20] - by_size[by_size.size() / 20];
}

/// That all but a hundredth of the readings at either end have, or but two: a machine that runs now
/// and then for a moment is in it.
double whole_range(const std::vector<double>& by_size) {
  if (by_size.empty()) return 0.0;
  const std::size_t ends = std::max<std::size_t>(2, by_size.size() / 100);
  return by_size[by_size.size() - 1 - ends] - by_size[ends];
}

/// Robust standard deviation of steady readings about the middle of their neighbours; NaN where
/// there are too few.
double scatter_of(const Readings& readings, const std::vector<bool>& steady, double range) {
  std::vector<double> off;
  for (std::size_t k = 0; k < readings.count(); ++k) {
    if (!steady[k]) continue;
    std::array around{readings[k - 2], readings[k - 1], readings[k + 1], readings[k + 2]};
    std::sort(around.begin(), around.end());
    off.push_back(std::abs(readings[k] - 0.5 * (around[1] + around[2])));
  }
  if (off.size() < fewest_steady) return unset;
  return std::max(1.4826 * record::median(off), finest * range);
}

/// Whether these readings leave their neighbours by more than `far` and return.
bool leave_and_return(const Readings& readings, std::size_t first, std::size_t last, double before,
                      double after, double far) {
  for (std::size_t k = first; k <= last; ++k) {
    const double one = readings[k] - before, other = readings[k] - after;
    const double least = std::min(std::abs(one), std::abs(other));
    if (!(one * other > 0.0) || !(least > far) || !(least > farther * std::abs(before - after)))
      return false;
  }
  return true;
}

}  // namespace

std::string Isolated::statement() const {
  std::string lines;
  for (std::size_t k = 0; k < rows.size() && k < most_lines; ++k)
    lines += fmt::format("{}{}", k == 0 ? "" : ", ", record.line(rows[k]));
  if (rows.size() > most_lines) lines += fmt::format(" and {} more", rows.size() - most_lines);
  return fmt::format(
      "{} reading{} of {} leave{} and return{} while the speed is steady{} and take{} no part, {} "
      "{}",
      rows.size(), rows.size() == 1 ? "" : "s", channel->words, rows.size() == 1 ? "s" : "",
      rows.size() == 1 ? "s" : "",
      impossible ? ", or by more than three times the range of the others," : "",
      rows.size() == 1 ? "s" : "", record.lines.empty() ? "rows" : "lines", lines);
}

Isolated without_isolated_readings(const record::Record& record) {
  for (const record::Column& c : record.columns)
    if (c.channel->role == record::Role::measured)
      return without_isolated_readings(record, *c.channel);
  return {.record = record};
}

Isolated without_isolated_readings(const record::Record& record, const record::Channel& channel) {
  Isolated result{.record = record};
  record::Column* const column = result.record.find(channel);
  if (!column || !record.complete(record::time)) return result;
  const Readings readings(record, *record.find(channel));
  const std::vector<bool> steady = steady_ones(readings);
  const std::vector<double> sorted = by_size(readings);
  const double scatter = scatter_of(readings, steady, usual_range(sorted)),
               whole = whole_range(sorted);
  if (!(scatter > 0.0) && !(whole > 0.0)) return result;
  std::vector<bool> isolated(readings.count(), false);
  for (std::size_t length = 1; length <= longest; ++length)
    for (std::size_t k = reach; k + length + reach <= readings.count(); ++k) {
      const std::size_t last = k + length - 1;
      std::size_t before = k - 1, after = last + 1;
      while (before > 0 && isolated[before]) --before;
      while (after + 1 < readings.count() && isolated[after]) ++after;
      const auto leave_by = [&](double far) {
        return far > 0.0 &&
               leave_and_return(readings, k, last, readings[before], readings[after], far);
      };
      const bool is_steady = std::all_of(steady.begin() + static_cast<std::ptrdiff_t>(k),
                                         steady.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                                         [](bool is) { return is; });
      const bool leaves_all = leave_by(impossible * whole);
      if (!leaves_all && !(is_steady && leave_by(far_away * scatter))) continue;
      result.impossible = result.impossible || (leaves_all && !is_steady);
      std::fill_n(isolated.begin() + static_cast<std::ptrdiff_t>(k), length, true);
    }
  for (std::size_t k = 0; k < isolated.size(); ++k)
    if (isolated[k]) result.rows.push_back(readings.row(k));
  if (static_cast<double>(result.rows.size()) >
      most_isolated * static_cast<double>(readings.count()))
    result.rows.clear();
  for (const std::size_t row : result.rows) column->values[row] = unset;
  if (result.any()) result.channel = column->channel;
  return result;
}

}  // namespace raceway::fit
